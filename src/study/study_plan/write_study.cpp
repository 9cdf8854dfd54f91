#include "study_plan/read_study.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace matrigrate::study {

namespace {

/// A string, or a list of strings, of TOML: those of JSON are a part of them.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }
std::string quoted(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(quoted(text));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

std::string statistics_section(const Comparisons& c) {
  std::string text = fmt::format("\n[statistics]\ncompare = \"{}\"\n", pairs_names[static_cast<std::size_t>(c.pairs)]);
  if (c.pairs == Pairs::control) text += fmt::format("control = {}\n", quoted(c.control));
  return text + fmt::format("test = \"{}\"\nalpha = {}\n", test_names[static_cast<std::size_t>(c.test)], c.alpha);
}

void add_settings(const std::vector<Setting>& settings, std::string& text) {
  for (const Setting& s : settings) text += fmt::format("\"{}\" = {}\n", s.key, s.value);
}

std::string target_section(const Study& study, const Target& t) {
  std::string text = fmt::format("\n[[targets]]\nreadout = {}\n", quoted(t.readout));
  if (t.tracks != nullptr) {
    const auto sets = measured_sets(study);
    const auto own = std::ranges::find(sets, t.tracks) - sets.begin();
    text += fmt::format("tracks = {}\n", quoted(measured_file(static_cast<std::size_t>(own))));
  } else {
    text += t.low == t.high ? fmt::format("value = {}\n", t.low) : fmt::format("low = {}\nhigh = {}\n", t.low, t.high);
    text += fmt::format("error = {}\n", t.error);
  }
  text += fmt::format("weight = {}\n", t.weight);
  if (t.at.empty()) return text;
  std::vector<std::string> labels;
  for (const std::size_t c : t.at) labels.push_back(study.conditions[c].label);
  return text + fmt::format("at = {}\n", quoted(labels));
}

} // namespace

std::string to_toml(const Study& study, const std::string& scenario) {
  std::string text = fmt::format("# A study with all its points written out{}. Running this file again adds nothing.\n",
                                 study.conditions.empty() ? "" : "; each is run at each condition");
  if (!study.title.empty()) text += fmt::format("title = {}\n", quoted(study.title));
  text +=
      fmt::format("scenario = {}\nreplicates = {}\nseed = {}\ncommon_random_numbers = {}\nreadouts = {}\n",
                  quoted(scenario), study.replicates, study.seed, study.common_random_numbers, quoted(study.readouts));
  text += statistics_section(study.comparisons);
  for (const Condition& condition : study.conditions) {
    text += fmt::format("\n[[conditions]]\nlabel = {}\n", quoted(condition.label));
    add_settings(condition.settings, text);
  }
  for (const Target& target : study.targets) text += target_section(study, target);
  for (const FactorSet& set : study.sets) {
    text += fmt::format("\n[[points]]\nlabel = {}\n", quoted(set.label));
    add_settings(set.settings, text);
  }
  for (const Claim& claim : study.claims) text += "\n" + claim.text;
  return text;
}

} // namespace matrigrate::study
