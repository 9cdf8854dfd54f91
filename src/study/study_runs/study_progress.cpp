#include "study_runs/study_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "run/estimate.hpp"
#include "run/run_record.hpp"
#include "tables/csv.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <map>
#include <stdexcept>
#include <tuple>

namespace matrigrate::study {

namespace {

namespace fs = std::filesystem;

/// True if a process works in the folder of a run. A process that begins a run waits until this test is over.
bool is_worked_on(const fs::path& folder) {
  const int descriptor = ::open((folder / ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = platform::lock(descriptor, platform::Lock::shared) == EWOULDBLOCK;
  ::close(descriptor);
  return locked;
}

/// Simulated time of the last row of tracks.csv [s].
double time_reached(const fs::path& folder) {
  const std::vector<double> t = store::csv_column(read_file(folder / "tracks.csv", largest_table), "t_s");
  return t.empty() ? 0.0 : t.back();
}

/// Wall time that went into a run so far: what run.json says, and the time since that was written [s].
double time_spent(const fs::path& folder) {
  const nlohmann::ordered_json record = run::record_of(folder);
  const auto found = record.find("wall_time_s");
  const double before = found != record.end() && found->is_number() ? found->get<double>() : 0.0;
  const auto since = fs::file_time_type::clock::now() - fs::last_write_time(folder / "run.json");
  return before + std::max(0.0, std::chrono::duration<double>(since).count());
}

std::optional<RunningRun> running_run(const StudyFolder& study, std::size_t i) {
  const fs::path folder = run_folder(study.folder, study.runs[i]);
  if (!is_worked_on(folder)) return {};
  RunningRun run{.run = i, .share = 0.0, .left = {}};
  try {
    const double whole = study.study.points[study.runs[i].point].parameters.run.duration;
    const double share = std::min(1.0, time_reached(folder) / whole);
    if (share > 0.0) run.left = time_spent(folder) * (1.0 - share) / share;
    run.share = share;
  } catch (const std::runtime_error&) { // its first files are being written
  }
  return run;
}

/// Time left for all runs together, from the done and the running runs.
std::optional<double> time_left(const StudyProgress& progress, const std::vector<Standing>& standings) {
  double left = 0.0;
  double whole = 0.0;
  std::size_t known = 0;
  for (const RunningRun& run : progress.running) {
    if (!run.left || run.share >= 1.0) continue;
    left += *run.left;
    whole += *run.left / (1.0 - run.share);
    ++known;
  }
  for (const Standing& s : standings) {
    if (!s.done()) continue;
    whole += s.wall_time;
    ++known;
  }
  if (progress.running.empty() || known == 0) return {};
  const double mean = whole / static_cast<double>(known);
  const auto closed = std::ranges::count_if(standings, &Standing::ended);
  const double waiting = static_cast<double>(standings.size() - progress.running.size()) - static_cast<double>(closed);
  for (const RunningRun& run : progress.running)
    if (!run.left) left += mean;
  return (left + mean * std::max(0.0, waiting)) / static_cast<double>(progress.running.size());
}

} // namespace

StudyProgress progress_of(const StudyFolder& study, const std::vector<Standing>& standings) {
  StudyProgress progress;
  for (std::size_t i = 0; i < study.runs.size(); ++i)
    if (standings[i].status == RunState::unfinished)
      if (auto run = running_run(study, i)) progress.running.push_back(*run);
  progress.left = time_left(progress, standings);
  return progress;
}

StudyCost cost(const StudyFolder& study) {
  StudyCost c;
  const auto replicates = static_cast<double>(study.study.replicates);
  std::map<std::tuple<double, double, Lattice>, std::size_t> counted; // particles of each matrix
  for (const Point& point : study.study.points) {
    const EcmParameters& ecm = point.parameters.ecm;
    const auto [matrix, is_new] = counted.try_emplace({ecm.radius, ecm.particle_spacing, ecm.lattice}, 0);
    if (is_new) matrix->second = run::particle_count(point.parameters);
    const run::RunCost run = run::run_cost(point.parameters, matrix->second);
    c.run_times.push_back(run.wall_time);
    c.wall_time += replicates * run.wall_time;
    c.memory_bytes = std::max(c.memory_bytes, run.memory_bytes);
    c.disk_bytes += replicates * run.disk_bytes;
  }
  // warnings take milliseconds per point: of many points some are looked at, spread evenly over the list
  const std::vector<Point>& points = study.study.points;
  c.looked_at = std::min<std::size_t>(points.size(), 200);
  for (std::size_t k = 0; k < c.looked_at; ++k) {
    const Point& point = points[k * points.size() / c.looked_at];
    for (const std::string& warning : run::warnings(point.parameters, run::derived(point.parameters)))
      c.warnings.push_back(fmt::format("{}: {}", point.label, warning));
  }
  return c;
}

} // namespace matrigrate::study
