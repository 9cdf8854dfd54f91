#include "run/run_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "cell/geometry.hpp"
#include "cell/nucleus.hpp"
#include "draw/cell_picture.hpp"
#include "draw/layer_picture.hpp"
#include "parameters/write.hpp"
#include "report/film_json.hpp"
#include "report/run_page.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"
#include "store/field_file.hpp"
#include "store/run_files.hpp"
#include "store/trajectory_hash.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <malloc.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate::run {

namespace {

/// "t_01800s"; times between full seconds keep their fraction: "t_00000.4s".
std::string time_name(double t) {
  const double rounded = std::round(1e3 * t) / 1e3;
  const double whole = std::floor(rounded);
  const std::string fraction = rounded > whole ? fmt::format("{:.3g}", rounded - whole).substr(1) : std::string();
  return fmt::format("t_{:05.0f}{}s", whole, fraction);
}

/// A row of protrusions.csv, which tells the cell where there are several.
std::vector<store::Field> fields_of(const State& s, const Cell& cell, const ProtrusionRecord& record,
                                    const Parameters& p) {
  std::vector<store::Field> fields = store::fields(record, p);
  return s.cells.size() > 1 ? store::with_cell(cell.id, std::move(fields)) : fields;
}

std::vector<std::string_view> protrusion_columns(const State& s) {
  return s.cells.size() > 1 ? store::with_cell(store::protrusion_columns()) : store::protrusion_columns();
}

} // namespace

RunFolder::RunFolder(std::filesystem::path folder, const Parameters& p, const RunRecord& record, const State& s,
                     store::RunMemory memory, const std::filesystem::path& from)
    : m_folder(std::move(folder)), m_lock(m_folder, FolderLock::Kind::alone, std::chrono::milliseconds(500)), m_p(p),
      m_memory(std::move(memory)), m_ended(s.cells.size()), m_row_cadence(p.output.track_interval, p.run.time_step),
      m_snapshot_cadence(p.output.pictures ? p.output.snapshot_interval : 0.0, p.run.time_step),
      m_frame_cadence(p.output.field_interval, p.run.time_step),
      m_checkpoint_cadence(p.output.checkpoint_interval, p.run.time_step),
      m_kept_cadence(p.output.kept_checkpoint_interval, p.run.time_step) {
  require_no_links(m_folder);
  remove_temporaries(m_folder);
  if (s.step == 0 && m_memory.rows.empty()) remove_run_files(m_folder); // of a run that this one replaces
  write_record(record);                                                 // first: it tells whose folder this is
  write_file(m_folder / "scenario.resolved.toml", to_toml(p));
  if (m_p.output.pictures) make_output_folder(m_folder / "snapshots", true);
  const auto open = [this](std::optional<store::RowFile>& file, const char* name, const auto& columns) {
    file.emplace(m_folder / name, columns, m_memory.tables[name]);
  };
  open(m_tracks, "tracks.csv", store::track_columns(has_nucleus(m_p)));
  open(m_health, "health.csv", store::health_columns());
  if (s.cells.size() > 1) open(m_group, "group.csv", store::group_columns());
  m_protrusions.emplace(m_folder / "protrusions.csv", protrusion_columns(s), m_protrusion_rows);
  add_ended(s);
  if (m_p.output.field_interval > 0.0) open_log(s, from.empty() ? m_folder : from);
  if (m_memory.rows.empty()) return;
  for (Cadence* cadence :
       {&m_row_cadence, &m_snapshot_cadence, &m_frame_cadence, &m_checkpoint_cadence, &m_kept_cadence})
    cadence->due(s.t); // what was due is done
  m_safe_until = s.t;
}

void RunFolder::begin(const State& s, const Workspace& w) {
  if (m_row_cadence.due(s.t)) add_row(s, w);
  if (m_snapshot_cadence.due(s.t)) add_snapshot(s, w);
  if (m_frame_cadence.due(s.t)) add_frame(s, w);
  m_kept_cadence.due(s.t);
  m_checkpoint_cadence.due(s.t);
  if (m_keeps_checkpoints) write_checkpoint(s, w, 0.0);
}

void RunFolder::see(const State& s, const Workspace& w, const RunRecord& record) {
  m_memory.watch.see(w.health);
  add_ended(s);
  if (m_row_cadence.due(s.t)) {
    require_health(s, add_row(s, w));
  }
  const bool snapshot = m_snapshot_cadence.due(s.t);
  if (snapshot) add_snapshot(s, w);
  if (m_frame_cadence.due(s.t)) add_frame(s, w);
  const bool keep = m_kept_cadence.due(s.t);
  const bool due = m_checkpoint_cadence.due(s.t) || keep;
  if (due && m_keeps_checkpoints) write_checkpoint(s, w, record.march_wall_time, keep);
  if (snapshot) write_record(record);
}

void RunFolder::require_health(const State& s, const HealthRow& row) const {
  if (const auto found = alarm(s, m_p, row))
    throw NumericalFailure(found->cause, fmt::format("step {} (t = {:.6g} s): {}", s.step, s.t, found->text));
}

/// The forces of the step before a checkpoint are not known to a run that goes on from there.
HealthRow RunFolder::health_row(const State& s, const Workspace& w, HealthWatch& watch) const {
  HealthRow row = watch.row(s, m_p, w.health);
  row.force_imbalance = s.step == m_memory.step ? m_memory.force_imbalance : force_imbalance(w);
  return row;
}

void RunFolder::write_checkpoint(const State& s, const Workspace& w, double march_wall_time, bool keep) {
  HealthWatch watch = m_memory.watch; // a copy: the next row still tells of the steps so far
  const HealthRow health = health_row(s, w, watch);
  require_health(s, health);
  if (m_frames) m_frames->flush();
  for (const auto* table : {&m_tracks, &m_health, &m_group})
    if (*table) (*table)->flush();
  m_memory.step = s.step;
  m_memory.force_imbalance = health.force_imbalance;
  m_memory.counts = w.health;
  m_memory.march_wall_time = march_wall_time;
  const std::filesystem::path checkpoints = m_folder / "checkpoints";
  if (keep) make_output_folder(checkpoints, true);
  store::write_checkpoint(m_folder,
                          {.state = s,
                           .scenario = to_toml(m_p),
                           .configuration_hash = configuration_hash(m_p),
                           .program = version_line(),
                           .memory = store::to_text(m_memory)},
                          keep ? std::optional(checkpoints / (time_name(s.t) + ".h5")) : std::nullopt);
  m_safe_until = s.t;
}

void RunFolder::see_last(const State& s, const Workspace& w, bool stopped) {
  add_ended(s);
  if (m_memory.rows.empty() || m_memory.rows.back().step != s.step) add_row(s, w);
  const bool drawn = !m_memory.scenes.empty() && m_memory.scenes.back().t == s.t;
  if (m_p.output.pictures && !drawn && !stopped) add_snapshot(s, w);
  if (m_frames && (m_frame_times.empty() || m_frame_times.back() != s.t)) add_frame(s, w);
}

void RunFolder::finish(const State& s, const std::string& status, bool failed, const RunRecord& record,
                       std::string_view page_template) {
  if (m_frames) store::write_field_files(m_folder, m_frame_times.size(), field_origin(m_p, trajectory_hash()));
  write_pictures(s, failed);
  m_results = cell_results(s, m_memory.rows, m_p);
  write_file(m_folder / "protrusions.csv", store::protrusions_csv(m_results, m_p)); // with those still alive
  write_file(m_folder / "msd.csv", store::msd_csv(m_results, 600.0));
  write_file(m_folder / "summary.csv", store::summary_csv(m_results));
  write_file(m_folder / "summary.json", store::summary_json(m_results));
  if (!m_p.output.report || page_template.empty()) return;
  ::malloc_trim(0); // before all frames that are played are in memory
  const nlohmann::ordered_json record_json = to_json(record, m_p);
  const std::string scenario = scenario_name(record_json, m_folder);
  const observe::Film film = m_frames ? store::read_film(m_folder, report::keep_what_is_played) : observe::Film{};
  write_file(m_folder / "report.html",
             report::filled_page(page_template, report::run_data({.title = run_title(m_p, scenario),
                                                                  .status = status,
                                                                  .facts = run_facts(m_p, record_json, scenario),
                                                                  .t_end = s.t,
                                                                  .p = m_p,
                                                                  .cells = m_results,
                                                                  .health = m_memory.tables.at("health.csv"),
                                                                  .film = m_frames ? &film : nullptr,
                                                                  .provenance = provenance_text()})));
}

void RunFolder::write_pictures(const State& s, bool failed) const {
  if (m_p.output.pictures) write_file(m_folder / "snapshots.svg", draw::contact_sheet(m_memory.scenes));
  if (!failed) return;
  const observe::CellScene scene = observe::cell_scene(s, m_p, {});
  write_file(m_folder / "failure.svg", draw::cell_picture(scene, observe::surroundings(std::span(&scene, 1), 15.0)));
}

void RunFolder::remove_log() {
  m_frames.reset();
  std::error_code error;
  std::filesystem::remove(m_folder / store::frame_log_name, error); // one that stays does no harm
}

void RunFolder::write_record(const RunRecord& record) const {
  const auto handler = nlohmann::ordered_json::error_handler_t::replace;
  write_file(m_folder / "run.json", to_json(record, m_p).dump(2, ' ', false, handler) + "\n");
}

std::string RunFolder::trajectory_hash() const { return store::TrajectoryHash(m_memory.trajectory).text(); }

HealthRow RunFolder::add_row(const State& s, const Workspace& w) {
  store::TrajectoryHash trajectory(m_memory.trajectory);
  trajectory.add(s);
  m_memory.trajectory = trajectory.value();
  if (m_group) m_group->add(store::fields(group_row(s, m_memory.rows, m_p)));
  for (const TrackRow& row : track_rows(s, m_p.cell.centre_of_mass)) {
    m_tracks->add(store::fields(row));
    m_memory.rows.push_back(row);
  }
  const HealthRow health = health_row(s, w, m_memory.watch);
  m_health->add(store::fields(health));
  return health;
}

void RunFolder::add_ended(const State& s) {
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    const Cell& cell = s.cells[k];
    for (; m_ended[k] < cell.ended.size(); ++m_ended[k])
      m_protrusions->add(fields_of(s, cell, cell.ended[m_ended[k]], m_p));
  }
}

void RunFolder::add_snapshot(const State& s, const Workspace& w) {
  std::vector<std::vector<Vec2>> paths;
  for (const Cell& cell : s.cells) {
    std::vector<Vec2>& path = paths.emplace_back();
    for (const TrackRow& row : m_memory.rows)
      if (row.cell == cell.id) path.push_back(row.centre);
    if (m_memory.rows.empty() || m_memory.rows.back().step != s.step)
      path.push_back(centre_of_mass(cell.cortex, m_p.cell.centre_of_mass));
  }
  observe::CellScene scene = observe::cell_scene(s, m_p, std::move(paths));
  const std::filesystem::path file = m_folder / "snapshots" / time_name(s.t);
  const auto layer = [&file](std::string_view name) { return file.string() + std::string(name) + ".svg"; };
  write_file(layer(""), draw::cell_picture(scene, observe::whole_disc(scene)));
  if (m_p.output.displacement_layer) write_file(layer("_displacement"), draw::displacement_picture(s, m_p));
  if (m_p.output.fibre_stress_layer && !w.fibres.empty())
    write_file(layer("_fibre_stress"), draw::fibre_stress_picture(s, m_p, w.fibres));
  scene.matrix.front() = {}; // the contact sheet draws the intact matrix as one area
  m_memory.scenes.push_back(std::move(scene));
}

void RunFolder::add_frame(const State& s, const Workspace& w) {
  m_frames->add(observe::frame(s, m_p, w));
  m_frame_times.push_back(s.t);
  if (m_memory.frames.empty() || m_memory.frames.back() < s.t) m_memory.frames.push_back(s.t);
}

/// Begins the log with those frames of the past that a folder still holds.
void RunFolder::open_log(const State& s, const std::filesystem::path& from) {
  const store::FrameShape shape{.head = observe::frame_head(s, m_p),
                                .outline = cortex_particles(s),
                                .fibres = m_p.fibres.arrangement != FibreArrangement::none};
  std::string log = store::log_head(shape.head);
  if (!m_memory.frames.empty())
    for (const auto& [t, frame] : store::saved_frames(from, shape, m_memory.frames)) {
      log += frame;
      m_frame_times.push_back(t);
    }
  m_frames.emplace(m_folder / store::frame_log_name, log);
}

store::LostFrames RunFolder::lost_frames() const {
  if (!m_frames) return {};
  return store::lost_frames(m_memory.frames, m_frame_times);
}

} // namespace matrigrate::run
