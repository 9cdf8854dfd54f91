#include "apps/run_folder.hpp"

#include "apps/provenance.hpp"
#include "base/file.hpp"
#include "io/cell_picture.hpp"
#include "io/layer_picture.hpp"
#include "io/run_files.hpp"
#include "io/run_page.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace matrigrate::apps {

namespace {

/// "t_01800s.svg"; times between full seconds keep their fraction: "t_00000.4s.svg".
std::string snapshot_name(double t, std::string_view layer = "") {
  const double rounded = std::round(1e3 * t) / 1e3;
  const double whole = std::floor(rounded);
  const std::string fraction = rounded > whole ? fmt::format("{:.3g}", rounded - whole).substr(1) : std::string();
  return fmt::format("t_{:05.0f}{}s{}.svg", whole, fraction, layer);
}

} // namespace

bool Cadence::due(double t) {
  if (t < m_next - m_slack) return false;
  m_next = m_interval * (std::floor((t + m_slack) / m_interval) + 1.0);
  return true;
}

RunFolder::RunFolder(std::filesystem::path folder, const Parameters& p, const RunRecord& record, const State& s,
                     const Workspace& w)
    : m_folder(std::move(folder)), m_p(p), m_tracks(m_folder / "tracks.csv", io::track_columns()),
      m_protrusions(m_folder / "protrusions.csv", io::protrusion_columns()),
      m_health(m_folder / "health.csv", io::health_columns()), m_row_cadence(p.output.track_interval, p.run.time_step),
      m_snapshot_cadence(p.output.snapshot_interval, p.run.time_step) {
  write_file(m_folder / "scenario.resolved.toml", to_toml(p));
  make_output_folder(m_folder / "snapshots", true);
  write_record(record);
  if (m_row_cadence.due(s.t)) add_row(s, w);
  if (m_snapshot_cadence.due(s.t)) add_snapshot(s, w);
}

void RunFolder::see(const State& s, const Workspace& w, const RunRecord& record) {
  m_watch.see(w.health);
  add_ended(s);
  if (m_row_cadence.due(s.t)) add_row(s, w);
  if (!m_snapshot_cadence.due(s.t)) return;
  add_snapshot(s, w);
  write_record(record);
}

void RunFolder::finish(const State& s, const Workspace& w, const std::string& status) {
  add_ended(s);
  if (m_rows.empty() || m_rows.back().step != s.step) add_row(s, w);
  if (m_scenes.empty() || m_scenes.back().t != s.t) add_snapshot(s, w);
  const std::vector<ProtrusionRecord> records = protrusion_records(s);
  m_readouts = matrigrate::readouts(m_rows, records, m_p);
  write_file(m_folder / "protrusions.csv", io::protrusions_csv(records, m_p.actomyosin)); // with those still alive
  write_file(m_folder / "msd.csv", io::msd_csv(mean_square_displacement(m_rows, 600.0)));
  write_file(m_folder / "summary.csv", io::summary_csv(m_readouts));
  write_file(m_folder / "summary.json", io::summary_json(m_readouts));
  const std::string sheet = io::contact_sheet(m_scenes);
  write_file(m_folder / "snapshots.svg", sheet);
  write_file(m_folder / "report.html", io::run_page({.title = fmt::format("Migration run, seed {}", m_p.run.seed),
                                                     .status = status,
                                                     .readouts = m_readouts,
                                                     .rows = m_rows,
                                                     .contact_sheet = sheet,
                                                     .provenance = provenance_text()}));
}

void RunFolder::write_record(const RunRecord& record) const {
  const auto handler = nlohmann::ordered_json::error_handler_t::replace;
  write_file(m_folder / "run.json", to_json(record, m_p).dump(2, ' ', false, handler) + "\n");
}

void RunFolder::add_row(const State& s, const Workspace& w) {
  m_trajectory.add(s);
  m_rows.push_back(track_row(s));
  m_tracks.add(io::fields(m_rows.back()));
  m_health.add(io::fields(m_watch.row(s, m_p, w.health)));
}

void RunFolder::add_ended(const State& s) {
  for (; m_ended < s.ended.size(); ++m_ended) m_protrusions.add(io::fields(s.ended[m_ended], m_p.actomyosin));
}

void RunFolder::add_snapshot(const State& s, const Workspace& w) {
  std::vector<Vec2> path;
  path.reserve(m_rows.size() + 1);
  for (const TrackRow& row : m_rows) path.push_back(row.centre);
  if (m_rows.empty() || m_rows.back().step != s.step) path.push_back(track_row(s).centre);
  io::CellScene scene = io::cell_scene(s, m_p, std::move(path));
  write_file(m_folder / "snapshots" / snapshot_name(s.t), io::cell_picture(scene, io::whole_disc(scene)));
  if (m_p.output.displacement_layer)
    write_file(m_folder / "snapshots" / snapshot_name(s.t, "_displacement"), io::displacement_picture(s, m_p));
  if (m_p.output.fibre_stress_layer && !w.fibres.empty())
    write_file(m_folder / "snapshots" / snapshot_name(s.t, "_fibre_stress"),
               io::fibre_stress_picture(s, m_p, w.fibres));
  scene.matrix.front() = {}; // the contact sheet draws the intact matrix as one area
  m_scenes.push_back(std::move(scene));
}

} // namespace matrigrate::apps
