#include "run/output.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/parallel.hpp"
#include "base/platform.hpp"
#include "cell/nucleus.hpp"
#include "report/film_json.hpp"
#include "report/run_page.hpp"
#include "run/provenance.hpp"
#include "state/dof.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "store/trajectory_hash.hpp"
#include "tables/run_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>

namespace matrigrate::run {

HealthRow health_row(const RunSoFar& run, const State& s, const Workspace& w, HealthWatch& watch) {
  HealthRow row = watch.row(s, run.p, w.health);
  row.force_imbalance = s.step == run.memory.step ? run.memory.force_imbalance : force_imbalance(w);
  return row;
}

void require_health(const RunSoFar& run, const State& s, const HealthRow& row) {
  if (const auto found = alarm(s, run.p, row))
    throw NumericalFailure(found->cause, fmt::format("step {} (t = {:.6g} s): {}", s.step, s.t, found->text));
}

namespace {

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
    HealthRow row;
    side_by_side({[&] { trajectory.add(s); }, [&] { row = health_row(run, s, w, memory.watch); }});
    memory.trajectory = trajectory.value();
    if (group) {
      memory.group.push_back(group_row(s, memory.rows, run.now));
      group->add(store::fields(memory.group.back()));
    }
    for (const TrackRow& track : track_rows(s)) {
      tracks->add(store::fields(track));
      memory.rows.push_back(track);
    }
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

/// The frames: the log fields.part, begun with those of the past that a folder still holds, and at the end fields.h5
/// and fields.xdmf.
Output fields(RunSoFar& run, const State& start) {
  if (run.p.output.field_interval <= 0.0) return {};
  const store::FrameShape shape{.head = observe::frame_head(start, run.p),
                                .outline = cortex_particles(start),
                                .fibres = run.p.fibres.arrangement != FibreArrangement::none};
  std::string text = store::log_head(shape.head);
  if (!run.memory.frames.empty())
    for (const auto& [t, frame] : store::saved_frames(run.frames_from, shape, run.memory.frames)) {
      text += frame;
      run.frame_times.push_back(t);
    }
  const auto log = std::make_shared<store::FrameLog>(run.folder / store::frame_log_name, text);
  Output output{.interval = run.p.output.field_interval};
  output.write = [=, &run](const State& s, const Workspace& w) {
    if (!run.frame_times.empty() && run.frame_times.back() == s.t) return;
    observe::Frame frame = observe::frame(s, run.now, w);
    store::follow(frame, shape); // a branch that has not begun yet has the fibres of its run
    run.behind.add([log, frame = std::move(frame)] { log->add(frame); });
    run.frame_times.push_back(s.t);
    if (run.memory.frames.empty() || run.memory.frames.back() < s.t) run.memory.frames.push_back(s.t);
  };
  output.flush = [=] { log->flush(); };
  output.finish = [&run](const RunFinish&) {
    const std::string hash = store::TrajectoryHash(run.memory.trajectory).text();
    store::write_field_files(run.folder, run.frame_times.size(), field_origin(run.p, hash));
  };
  output.remove_what_resuming_needs = [&run] {
    std::error_code error;
    std::filesystem::remove(run.folder / store::frame_log_name, error); // one that stays does no harm
  };
  return output;
}

/// report.html, made at the end.
Output report_page(RunSoFar& run, const State&) {
  Output output;
  output.finish = [&run](const RunFinish& end) {
    if (!run.p.output.report || end.page_template.empty()) return;
    platform::give_back_memory(); // before all frames that are played are in memory
    const bool frames = run.p.output.field_interval > 0.0;
    const nlohmann::ordered_json record = to_json(end.record, run.p);
    const std::string scenario = scenario_name(record, run.folder);
    const observe::Film film = frames ? store::read_film(run.folder, report::keep_what_is_played) : observe::Film{};
    write_file(run.folder / "report.html",
               report::filled_page(end.page_template, report::run_data({.title = run_title(run.p, scenario),
                                                                        .status = end.status,
                                                                        .facts = run_facts(run.p, record, scenario),
                                                                        .t_end = end.s.t,
                                                                        .p = run.p,
                                                                        .cells = end.cells,
                                                                        .health = run.memory.tables.at("health.csv"),
                                                                        .film = frames ? &film : nullptr,
                                                                        .provenance = provenance_text()})));
  };
  return output;
}

} // namespace

std::span<const OutputKind> output_kinds() {
  static constexpr auto kinds = std::to_array<OutputKind>({
      {"", R"(checkpoint(_prev|_next)?\.h5|scenario\.resolved\.toml|run\.json)"},
      {"checkpoints", R"(t_[0-9.]+s\.h5)"},
      {"", R"(protrusions\.csv)", protrusions},
      {"", R"((tracks|health|group)\.csv)", rows},
      {"snapshots", R"(t_[0-9.]+s(_displacement|_fibre_stress)?\.svg)"}, // of earlier versions
      {"", R"((snapshots|failure)\.svg)"},                               // as well
      {"", R"(fields\.(h5|xdmf|part))", fields},
      {"", R"((msd|summary)\.csv|summary\.json)", results},
      {"", R"(report\.html)", report_page},
  });
  return kinds;
}

} // namespace matrigrate::run
