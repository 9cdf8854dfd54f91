#include "apps/study/verbs.hpp"

#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace matrigrate::apps {

namespace {

constexpr std::size_t most_shown = 30; // points or pairs that a person reads

/// @param lost  runs of each point that ended at the rim: a column, if there are any
std::string groups_text(const StudyFolder& study, const std::vector<study::ReadOutSample>& samples,
                        const std::string& readout, const std::vector<std::size_t>& lost) {
  std::vector<std::vector<std::string>> rows{
      {"point", "n", "mean", fmt::format("{:.3g} % interval", 100.0 * (1.0 - study.study.comparisons.alpha))}};
  const bool any = std::ranges::any_of(lost, [](std::size_t n) { return n > 0; });
  if (any) rows[0].emplace_back("lost at the rim");
  for (const study::ReadOutSample& s : samples) {
    if (s.readout != readout) continue;
    rows.push_back({study::point_text(study.study, s.point), fmt::format("{}", s.moments.n), number_text(s.mean.value),
                    interval_text(s.mean)});
    if (any) rows.back().push_back(fmt::format("{}", lost[s.point]));
  }
  return aligned(rows, 1);
}

/// Too few runs for a test: no p is shown.
bool few_runs(const study::Comparison& c) { return std::min(c.sample_a.n, c.sample_b.n) < study::least_runs; }

/// Only pairs of which something can be said.
std::string comparisons_text(const StudyFolder& study, const std::vector<study::Comparison>& comparisons,
                             const std::string& readout) {
  std::vector<std::vector<std::string>> rows{
      {"from", "to", "difference", "interval", "p", "Holm's p", "Hedges' g", "detectable"}};
  std::size_t left_out = 0;
  for (const study::Comparison& c : comparisons) {
    if (c.readout != readout || std::isnan(c.difference.value)) continue;
    if (rows.size() > most_shown) {
      ++left_out;
      continue;
    }
    rows.push_back({study.study.points[c.a].label, study.study.points[c.b].label, number_text(c.difference.value),
                    few_runs(c) ? "-" : interval_text(c.difference), few_runs(c) ? "-" : number_text(c.test.p),
                    few_runs(c) ? "-" : number_text(c.p_holm), number_text(c.g.value), number_text(c.detectable)});
  }
  if (rows.size() == 1) return {};
  constexpr std::size_t widest = 80;
  std::string text = aligned(rows, 2);
  if (text.find('\n') > widest) { // each pair on a line of its own
    std::vector<std::vector<std::string>> numbers;
    numbers.reserve(rows.size());
    for (const auto& row : rows) numbers.emplace_back(row.begin() + 2, row.end());
    std::istringstream lines(aligned(numbers, 0));
    text.clear();
    std::string line;
    for (std::size_t i = 0; std::getline(lines, line); ++i)
      text += (i == 0 ? "  from -> to\n" : fmt::format("  {} -> {}\n", rows[i][0], rows[i][1])) + "  " + line + "\n";
  }
  return "\n" + text + (left_out > 0 ? fmt::format("  and {} more in statistics.csv\n", left_out) : std::string());
}

/// Notes on the numbers above.
std::string remarks_text(const std::vector<study::Comparison>& comparisons) {
  if (comparisons.empty()) return {};
  const bool few = std::ranges::any_of(comparisons, few_runs);
  return fmt::format("Holm's p is corrected over all pairs of a read-out; detectable: the smallest\n"
                     "difference that as many runs find with {:.0f} % power.\n{}",
                     100.0 * study::wanted_power,
                     few ? fmt::format("A p needs at least {} runs at each point; below that \"-\" is printed\n"
                                       "(statistics.csv holds all p).\n",
                                       study::least_runs)
                         : "");
}

} // namespace

void write_study_report(const StudyFolder& study, Collected& collected, const std::vector<std::string>& played,
                        const std::vector<tracks::CellTrack>& tracks) {
  if (const std::string fault = study::fault_of_wanted(collected.results, played); !fault.empty())
    throw UsageError(fault);
  study::write_study_report(study, collected,
                            {.page_template = study_page_template(), .played = played, .tracks = tracks});
}

std::string collected_text(const StudyFolder& study, const Collected& collected) {
  const std::vector<study::ReadOutSample> samples = study::samples(study.study, collected.results);
  const std::vector<std::size_t> lost = lost_at_rim(study.study, collected.results);
  std::string text;
  for (const std::string& readout : study.study.readouts) {
    const bool defined = std::ranges::any_of(
        samples, [&](const study::ReadOutSample& s) { return s.readout == readout && s.moments.n > 0; });
    text += readout + (defined ? "\n" : ": no run has a value yet\n");
    if (!defined) continue;
    if (study.study.points.size() <= most_shown) text += groups_text(study, samples, readout, lost);
    text += comparisons_text(study, collected.comparisons, readout) + "\n";
  }
  return text + remarks_text(collected.comparisons)
         + (collected.claims.empty() ? "" : "\n" + claims_text(collected.claims));
}

std::string claims_text(const std::vector<study::JudgedClaim>& claims) {
  std::vector<std::vector<std::string>> cells{{"row", "kind", "verdict", "claim"}};
  for (const study::JudgedClaim& c : claims)
    cells.push_back({c.id, kind_name(c.kind),
                     to_string(c.finding.verdict) + (c.caveat.empty() ? "" : fmt::format(" ({})", c.caveat)),
                     c.sentence});
  return fmt::format("{}{}.\n", aligned(cells, 4), study::bottom_line(claims));
}

} // namespace matrigrate::apps
