#include "apps/study/discrepancy_text.hpp"

#include "apps/terminal/terminal.hpp"
#include "study_plan/names.hpp"
#include "study_results/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace matrigrate::apps {

std::string discrepancy_text(const study::Study& study, const std::vector<study::Discrepancy>& all) {
  constexpr std::size_t most_rows = 10; // rows that a person reads
  if (all.empty()) return {};
  const std::size_t targets = study::terms(study).size();
  std::vector<std::vector<std::string>> rows{
      {"factors", "discrepancy", fmt::format("{:.3g} % interval", 100.0 * (1.0 - study.comparisons.alpha)), "targets"}};
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

} // namespace matrigrate::apps
