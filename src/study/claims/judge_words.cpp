#include "claims/judge.hpp"

#include "observe/readout_table.hpp"
#include "statistics/compare.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

// What a judge says of the evidence, in words.
namespace matrigrate::study {

std::string Judge::readout_words(std::string_view readout) {
  const ReadOutSpec* spec = find_readout(readout);
  return spec == nullptr ? std::string(readout) : spec->meaning_with_unit();
}

void Judge::tell(const Group& g, const std::string& what, const statistics::Interval& mean, std::size_t n) {
  const std::string value = n < 2 ? fmt::format("{:.3g}", mean.value)
                                  : fmt::format("{:.3g} [{:.3g}, {:.3g}]", mean.value, mean.low, mean.high);
  const std::string text = fmt::format("{}: {} at {} (n = {})", what, n == 0 ? "no runs" : value, g.label, n);
  if (std::ranges::find(m_ours, text) != m_ours.end()) return;
  m_ours.push_back(text);
  if (n > 0) m_means.push_back({g, what, value});
}

/// A sentence of a rule with the names of what it is about.
std::string Judge::filled(std::string_view sentence, const ClaimCondition& c, const Group& from,
                          const Group& to) const {
  const std::pair<std::string_view, std::string> names[] = {{"$readout", readout_words(c.readout)},
                                                            {"$other", readout_words(c.other)},
                                                            {"$from", from.label},
                                                            {"$to", to.label},
                                                            {"$study", c.study.empty() ? m_study : c.study}};
  std::string text;
  for (std::string_view rest = sentence; !rest.empty();) {
    const auto name = std::ranges::find_if(names, [&](const auto& one) { return rest.starts_with(one.first); });
    text += name == std::end(names) ? std::string(1, rest.front()) : name->second;
    rest.remove_prefix(name == std::end(names) ? 1 : name->first.size());
  }
  return text;
}

/// All means if they are few, else the first and the last of each read-out, in the order of its points.
std::string Judge::brief() const {
  constexpr std::size_t few = 5;
  std::vector<std::string> parts;
  std::vector<std::string> all;
  for (const Mean& m : m_means)
    if (std::ranges::find(all, m.what) == all.end()) all.push_back(m.what);
  for (const std::string& what : all) {
    std::vector<const Mean*> of;
    for (const Mean& m : m_means)
      if (m.what == what) of.push_back(&m);
    std::ranges::stable_sort(of, {}, [](const Mean* m) { return std::pair(m->group.study, m->group.point); });
    if (m_means.size() > few && of.size() > 2) of = {of.front(), of.back()};
    std::vector<std::string> values;
    for (const Mean* m : of) values.push_back(fmt::format("{} ({})", m->value, m->group.label));
    parts.push_back(fmt::format("{}: {}", what, fmt::join(values, ", ")));
  }
  parts.insert(parts.end(), m_others.begin(), m_others.end());
  return fmt::format("{}", fmt::join(parts, "; "));
}

} // namespace matrigrate::study
