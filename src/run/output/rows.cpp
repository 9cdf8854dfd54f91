#include "cell/nucleus.hpp"
#include "run/output/output.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"

namespace matrigrate::run {

/// tracks.csv, health.csv and, of several cells, group.csv; the fingerprint of the trajectory grows with their rows.
Output rows(RunSoFar& run, const State& start) {
  const auto tracks = run.table("tracks.csv", store::track_columns(has_nucleus(run.p)));
  const auto health = run.table("health.csv", store::health_columns());
  const auto group = start.cells.size() > 1 ? run.table("group.csv", store::group_columns()) : nullptr;
  Output output{.interval = run.p.output.track_interval};
  output.write = [=, &run](const State& s, const Workspace& w) {
    store::RunMemory& memory = run.memory;
    if (!memory.rows.empty() && memory.rows.back().step == s.step) return;
    store::TrajectoryHash trajectory(memory.trajectory);
    trajectory.add(s);
    memory.trajectory = trajectory.value();
    if (group) {
      memory.group.push_back(group_row(s, memory.rows, run.p));
      group->add(store::fields(memory.group.back()));
    }
    for (const TrackRow& row : track_rows(s)) {
      tracks->add(store::fields(row));
      memory.rows.push_back(row);
    }
    const HealthRow row = health_row(run, s, w, memory.watch);
    health->add(store::fields(row));
    require_health(run, s, row);
  };
  output.flush = [=] {
    for (const auto& table : {tracks, health, group})
      if (table) table->flush();
  };
  return output;
}

} // namespace matrigrate::run
