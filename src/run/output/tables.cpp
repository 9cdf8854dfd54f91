#include "base/file.hpp"
#include "cell/nucleus.hpp"
#include "run/output/output.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"

namespace matrigrate::run {

/// protrusions.csv: those that have ended, which the state holds, and at the end of the run those still alive.
Output protrusions(RunSoFar& run, const State& start) {
  const bool several = start.cells.size() > 1;
  const auto columns = several ? store::with_cell(store::protrusion_columns()) : store::protrusion_columns();
  const std::filesystem::path file = run.folder / "protrusions.csv";
  const auto text = std::make_shared<std::string>();
  const auto table = std::make_shared<store::RowFile>(file, columns, *text);
  Output output{.interval = each_step};
  output.write = [=, &p = run.p, written = std::vector<std::size_t>(start.cells.size())](const State& s,
                                                                                         const Workspace&) mutable {
    for (std::size_t k = 0; k < s.cells.size(); ++k)
      for (const Cell& cell = s.cells[k]; written[k] < cell.ended.size(); ++written[k]) {
        const std::vector<store::Field> fields = store::fields(cell.ended[written[k]], p);
        table->add(several ? store::with_cell(cell.id, fields) : fields);
      }
  };
  output.finish = [=, &p = run.p, held = text](const RunFinish& end) {
    write_file(file, store::protrusions_csv(end.cells, p));
  };
  return output;
}

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
      memory.group.push_back(group_row(s, memory.rows, run.now));
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

/// The read-outs of each cell, made at the end: msd.csv, summary.csv and summary.json.
Output results(RunSoFar& run, const State&) {
  Output output;
  output.finish = [&folder = run.folder](const RunFinish& end) {
    write_file(folder / "msd.csv", store::msd_csv(end.cells, 600.0));
    write_file(folder / "summary.csv", store::summary_csv(end.cells));
    write_file(folder / "summary.json", store::summary_json(end.cells));
  };
  return output;
}

} // namespace matrigrate::run
