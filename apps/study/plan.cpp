#include "apps/study/verbs.hpp"

#include "apps/terminal/progress.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/text.hpp"
#include "study_runs/study_progress.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>

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

} // namespace

int print_plan(const StudyFolder& study, int jobs, bool json) {
  const study::StudyCost c = study::cost(study);
  if (json) {
    print(to_json(study, c, jobs).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
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

} // namespace matrigrate::apps
