#include "study/read_study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace matrigrate::study {

namespace {

/// A string of TOML: those of JSON are a part of them.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

std::string statistics_section(const Comparisons& c) {
  static constexpr const char* pairs[] = {"none", "adjacent", "all", "control"};
  static constexpr const char* tests[] = {"t", "welch", "mann_whitney"};
  std::string text = fmt::format("\n[statistics]\ncompare = \"{}\"\n", pairs[static_cast<std::size_t>(c.pairs)]);
  if (c.pairs == Pairs::control) text += fmt::format("control = {}\n", quoted(c.control));
  return text + fmt::format("test = \"{}\"\nalpha = {}\n", tests[static_cast<std::size_t>(c.test)], c.alpha);
}

} // namespace

std::string to_toml(const Study& study, const std::string& scenario) {
  std::string text = "# A study with all its points written out. Running this file again adds nothing.\n";
  if (!study.title.empty()) text += fmt::format("title = {}\n", quoted(study.title));
  text += fmt::format("scenario = {}\nreplicates = {}\nseed = {}\ncommon_random_numbers = {}\nreadouts = [",
                      quoted(scenario), study.replicates, study.seed, study.common_random_numbers);
  for (std::size_t i = 0; i < study.readouts.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", quoted(study.readouts[i]));
  text += "]\n" + statistics_section(study.comparisons);
  for (const Point& point : study.points) {
    text += fmt::format("\n[[points]]\nlabel = {}\n", quoted(point.label));
    for (const Setting& s : point.settings) text += fmt::format("\"{}\" = {}\n", s.key, s.value);
  }
  return text;
}

} // namespace matrigrate::study
