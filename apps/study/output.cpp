#include "apps/study/verbs.hpp"

#include "apps/terminal/progress.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/text.hpp"
#include "study_plan/names.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_points = 60;  ///< that are listed for people
constexpr std::size_t max_warnings = 5; ///< that are printed

Json to_json(const StudyFolder& study, const study::StudyCost& c, int jobs) {
  Json points = Json::array();
  for (std::size_t i = 0; i < study.study.points.size(); ++i) {
    Json settings = Json::object();
    for (const study::Setting& s : study.study.points[i].settings) settings[s.key] = Json::parse(s.value);
    points.push_back(
        {{"label", study.study.points[i].label}, {"settings", settings}, {"run_time_estimate_s", c.run_times[i]}});
  }
  Json runs = Json::array();
  for (const study::Run& run : study.runs)
    runs.push_back({{"run", run.hash}, {"point", run.point}, {"replicate", run.replicate}, {"seed", run.seed}});
  return {{"title", study.study.title},
          {"folder", study.folder.string()},
          {"replicates", study.study.replicates},
          {"jobs", jobs},
          {"wall_time_estimate_s", c.wall_time / jobs},
          {"memory_estimate_bytes", c.memory_bytes * jobs},
          {"disk_estimate_bytes", c.disk_bytes},
          {"warnings", c.warnings},
          {"points_looked_at_for_warnings", c.looked_at},
          {"points", points},
          {"runs", runs}};
}

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

int print_plan(const StudyFolder& study, int jobs, bool json) {
  const study::StudyCost c = study::cost(study);
  if (json) {
    print_json(to_json(study, c, jobs));
    return done;
  }
  const std::size_t n = study.study.points.size();
  if (!study.study.title.empty()) print(study.study.title + "\n");
  const std::size_t conditions = study.study.conditions.size();
  const std::string crossed =
      conditions == 0 ? std::string()
                      : fmt::format(" ({} factor sets x {} conditions)", study.study.sets.size(), conditions);
  print(fmt::format("{} point{}{} x {} replicates = {} runs, into {}\n\n", n, n == 1 ? "" : "s", crossed,
                    study.study.replicates, study.runs.size(), study.folder.string()));
  for (std::size_t i = 0; i < std::min(n, max_points); ++i)
    print(fmt::format("  {:<48} {} a run\n", study.study.points[i].label, wall_time_text(c.run_times[i])));
  if (n > max_points) print(fmt::format("  ... and {} more\n", n - max_points));
  print(fmt::format("\nwall time  {} with {} run{} at a time (estimate; {} one after the other)\n"
                    "memory     {:.0f} MB\ndisk       {:.0f} MB\n",
                    wall_time_text(c.wall_time / jobs), jobs, jobs == 1 ? "" : "s", wall_time_text(c.wall_time),
                    jobs * c.memory_bytes / 1e6, c.disk_bytes / 1e6));
  for (const study::Target& target : study.study.targets)
    for (const std::string& note : target.notes) print(fmt::format("tracks     {}\n", note));
  if (c.looked_at < n)
    print(fmt::format("warnings   looked for at {} of the {} points, spread evenly; {} found\n", c.looked_at, n,
                      c.warnings.size()));
  for (std::size_t i = 0; i < std::min(c.warnings.size(), max_warnings); ++i)
    print(fmt::format("\n{} {}\n", coloured("WARNING:", Colour::warning, Stream::out), c.warnings[i]));
  if (c.warnings.size() > max_warnings)
    print(fmt::format("\n... and {} more warnings\n", c.warnings.size() - max_warnings));
  return done;
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
