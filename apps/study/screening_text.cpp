#include "apps/study/screening_text.hpp"

#include "apps/terminal/text_table.hpp"
#include "study/comparison.hpp"
#include "study/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

namespace matrigrate::apps {

namespace {

constexpr std::size_t most_rows = 10; // rows that a person reads

std::string percent(const study::Study& study) {
  return fmt::format("{:.3g} % interval", 100.0 * (1.0 - study.comparisons.alpha));
}

std::string sets_text(const study::Study& study, const std::vector<study::Discrepancy>& all) {
  const std::size_t targets = study::terms(study).size();
  std::vector<std::vector<std::string>> rows{{"factors", "discrepancy", percent(study), "targets"}};
  for (const std::size_t i : study::ranking(all)) {
    if (rows.size() > most_rows) break;
    rows.push_back({set_text(study, all[i].set), number_text(all[i].value.value),
                    study.replicates < study::least_runs ? "-" : interval_text(all[i].value),
                    fmt::format("{} of {}", all[i].judged, targets)});
  }
  std::string text = "discrepancy from the targets\n" + aligned(rows, 1);
  if (all.size() > most_rows) text += fmt::format("  and {} more in discrepancy.csv\n", all.size() - most_rows);
  const auto partly = std::ranges::count_if(all, [&](const auto& d) { return d.judged < targets; });
  if (partly > 0)
    text += fmt::format("  {} of {} could not be judged by all targets: a target needs 2 runs with a value.\n", partly,
                        all.size());
  return text + "\n";
}

/// "rupture true"; of Morris' design the factor alone.
std::string title(const study::Names& names, const study::Effect& e) {
  std::string value = e.value;
  std::erase(value, '"');
  return names.of(e.factor) + (value.empty() ? "" : " " + value);
}

/// "0.5 (0.1 to 0.9)"
std::string cell(const study::Study& study, const study::Effect& e) {
  const std::string value = number_text(e.ranked().value);
  const std::string interval = has_interval(study, e) ? interval_text(e.ranked()) : "-";
  return interval == "-" ? value : fmt::format("{} ({})", value, interval);
}

/// A factor and its effects, one a condition.
struct Line {
  std::string title;
  double size = 0.0; ///< of its largest effect
  std::vector<std::string> cells;
};

/// Effects of one design on one read-out: a row a factor, a column a condition.
std::string effects_text(const study::Study& study, std::span<const study::Effect> all) {
  const study::Effect& first = all.front();
  const bool morris = first.design == study::Design::morris;
  const std::string what = fmt::format("factors by effect on {} ({}, {})", first.readout,
                                       morris ? "mu* of Morris" : "value less base", percent(study));
  if (std::ranges::none_of(all, [](const study::Effect& e) { return e.rank > 0; }))
    return what + ": none is defined yet\n\n";
  std::vector<std::string> head{"factor"};
  std::vector<Line> lines;
  const study::Names names(study);
  for (const study::Effect& e : all) {
    const std::string column = e.condition ? study.conditions[*e.condition].label : morris ? "mu*" : "effect";
    if (head.size() == 1 + e.condition.value_or(0)) head.push_back(column);
    auto line = std::ranges::find(lines, title(names, e), &Line::title);
    if (line == lines.end()) line = lines.insert(line, {title(names, e), 0.0, {}});
    line->cells.push_back(cell(study, e));
    if (e.rank > 0) line->size = std::max(line->size, std::abs(e.ranked().value));
  }
  std::ranges::stable_sort(lines, std::greater(), &Line::size);
  std::vector<std::vector<std::string>> rows{head};
  for (std::size_t i = 0; i < std::min(most_rows, lines.size()); ++i) {
    rows.push_back({lines[i].title});
    rows.back().insert(rows.back().end(), lines[i].cells.begin(), lines[i].cells.end());
  }
  return what + "\n" + aligned(rows, 1)
         + (lines.size() > most_rows ? fmt::format("  and {} more in effects.csv\n", lines.size() - most_rows) : "")
         + "\n";
}

} // namespace

std::string screening_text(const study::Study& study, const study::Screening& screening) {
  std::string text;
  if (!screening.discrepancies.empty()) text += sets_text(study, screening.discrepancies);
  const std::span<const study::Effect> all(screening.effects);
  for (std::size_t from = 0; from < all.size();) {
    std::size_t to = from;
    while (to < all.size() && all[to].design == all[from].design && all[to].readout == all[from].readout) ++to;
    text += effects_text(study, all.subspan(from, to - from));
    from = to;
  }
  return text;
}

} // namespace matrigrate::apps
