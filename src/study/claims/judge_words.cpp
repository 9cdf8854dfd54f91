#include "claims/judge.hpp"

#include "observe/readout_table.hpp"
#include "statistics/compare.hpp"
#include "study/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

// What a judge says of the evidence, in words.
namespace matrigrate::study {

namespace {

/// Takes a name out of a text, but not the end of a path.
void drop_name(std::string& text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;)
    if (at > 0 && text[at - 1] == '.')
      at += name.size();
    else
      text.erase(at, name.size());
}

} // namespace

void Judge::tell(const Group& g, std::string_view readout, const std::vector<double>& x) {
  const statistics::Interval mean = statistics::mean_interval(x, alpha);
  const std::string value = x.size() < 2 ? fmt::format("{:.3g}", mean.value)
                                         : fmt::format("{:.3g} [{:.3g}, {:.3g}]", mean.value, mean.low, mean.high);
  const std::string text = x.empty() ? fmt::format("{} at {}: no runs", readout, g.label)
                                     : fmt::format("{} at {} {} (n = {})", readout, g.label, value, x.size());
  if (std::ranges::find(m_ours, text) != m_ours.end()) return;
  m_ours.push_back(text);
  if (!x.empty()) m_means.push_back({g, std::string(readout), value});
}

/// A number over all runs of a study.
void Judge::tell_all(const std::string& text) {
  m_ours.push_back(text);
  m_others.push_back(text);
}

/// Without what a table has no room for: units of read-outs, the name of the parameter that varies, effect sizes.
std::string Judge::shortened(std::string text) const {
  const auto replace = [&](std::string_view what, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
      text.replace(at, what.size(), with);
  };
  for (const ReadOutSpec& readout : readout_table()) replace(readout.name, readout.label);
  for (const auto& [name, ensemble] : m_evidence) {
    const Names names(ensemble.study);
    for (const std::string& key : swept_keys(ensemble.study))
      if (key.ends_with("." + names.of(key))) drop_name(text, names.of(key) + " "); // whole paths tell two apart
  }
  for (std::size_t at; (at = text.find(", g ")) != std::string::npos;) text.erase(at, text.find(']', at) + 1 - at);
  return text;
}

/// All means if they are few, else the first and the last of each read-out, in the order of its points.
std::string Judge::brief() const {
  constexpr std::size_t few = 5;
  std::vector<std::string> parts;
  std::vector<std::string> readouts;
  for (const Mean& m : m_means)
    if (std::ranges::find(readouts, m.readout) == readouts.end()) readouts.push_back(m.readout);
  for (const std::string& readout : readouts) {
    std::vector<const Mean*> of;
    for (const Mean& m : m_means)
      if (m.readout == readout) of.push_back(&m);
    std::ranges::stable_sort(of, {}, [](const Mean* m) { return std::pair(m->group.study, m->group.point); });
    if (m_means.size() > few && of.size() > 2) of = {of.front(), of.back()};
    std::vector<std::string> values;
    for (const Mean* m : of) values.push_back(fmt::format("{} ({})", m->value, shortened(m->group.label)));
    parts.push_back(fmt::format("{} {}", shortened(readout), fmt::join(values, ", ")));
  }
  for (const std::string& other : m_others) parts.push_back(shortened(other));
  return fmt::format("{}", fmt::join(parts, "; "));
}

} // namespace matrigrate::study
