#include "run/run_folder.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/write.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "store/checkpoint.hpp"
#include "store/trajectory_hash.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace matrigrate::run {

namespace {

/// "t_01800s"; times between full seconds keep their fraction: "t_00000.4s".
std::string time_name(double t) {
  const double rounded = std::round(1e3 * t) / 1e3;
  const double whole = std::floor(rounded);
  const std::string fraction = rounded > whole ? fmt::format("{:.3g}", rounded - whole).substr(1) : std::string();
  return fmt::format("t_{:05.0f}{}s", whole, fraction);
}

} // namespace

RunFolder::RunFolder(const std::filesystem::path& folder, const Parameters& p, const RunRecord& record,
                     const Simulation& simulation, store::RunMemory memory, const std::filesystem::path& from)
    : m_run{.folder = folder,
            .p = p,
            .now = simulation.p,
            .memory = std::move(memory),
            .frames_from = from.empty() ? folder : from},
      m_lock(folder, FolderLock::Kind::alone, std::chrono::milliseconds(500)),
      m_checkpoint_cadence(p.output.checkpoint_interval, p.run.time_step),
      m_kept_cadence(p.output.kept_checkpoint_interval, p.run.time_step) {
  const State& s = simulation.s;
  require_no_links(folder);
  remove_temporaries(folder);
  const bool is_new = m_run.memory.rows.empty();
  if (s.step == 0 && is_new) remove_run_files(folder); // of a run that this one replaces
  write_record(record);                                // first: it tells whose folder this is
  write_file(folder / "scenario.resolved.toml", to_toml(p));
  for (const OutputKind& kind : output_kinds()) {
    if (kind.begin == nullptr) continue;
    Output output = kind.begin(m_run, s);
    const Cadence cadence(output.interval, p.run.time_step);
    m_outputs.push_back({std::move(output), cadence});
  }
  if (is_new) return;
  for (Regular& regular : m_outputs) regular.cadence.due(s.t); // what was due is done
  for (Cadence* cadence : {&m_checkpoint_cadence, &m_kept_cadence}) cadence->due(s.t);
  m_safe_until = s.t;
}

RunFolder::~RunFolder() { m_run.behind.settle(); }

void RunFolder::write_due(const State& s, const Workspace& w) {
  for (auto& [output, cadence] : m_outputs)
    if (cadence.due(s.t)) output.write(s, w);
}

void RunFolder::begin(const State& s, const Workspace& w) {
  write_due(s, w);
  for (Cadence* cadence : {&m_checkpoint_cadence, &m_kept_cadence}) cadence->due(s.t);
  if (m_keeps_checkpoints) write_checkpoint(s, w, 0.0);
}

void RunFolder::note_step(const Workspace& w) { m_run.memory.watch.see(w.health); }

void RunFolder::see(const State& s, const Workspace& w, const RunRecord& record) {
  m_run.behind.check();
  note_step(w);
  write_due(s, w);
  const bool keep = m_kept_cadence.due(s.t);
  const bool due = m_checkpoint_cadence.due(s.t) || keep;
  if (due && m_keeps_checkpoints) write_checkpoint(s, w, record.march_wall_time, keep);
  if (due) m_run.behind.add([this, record] { write_file(m_run.folder / "run.json", text_of(record)); });
}

void RunFolder::write_checkpoint(const State& s, const Workspace& w, double march_wall_time, bool keep) {
  HealthWatch watch = m_run.memory.watch; // a copy: the next row still tells of the steps so far
  const HealthRow health = health_row(m_run, s, w, watch);
  require_health(m_run, s, health);
  m_run.memory.step = s.step;
  m_run.memory.force_imbalance = health.force_imbalance;
  m_run.memory.counts = w.health;
  m_run.memory.march_wall_time = march_wall_time;
  const std::filesystem::path checkpoints = m_run.folder / "checkpoints";
  if (keep) make_folder(checkpoints);
  const auto now = std::make_shared<store::Checkpoint>(
      store::Checkpoint{s, {}, {}, version_line(), store::to_text(m_run.memory)}); // the rest is below
  const auto kept = keep ? std::optional(checkpoints / (time_name(s.t) + ".h5")) : std::nullopt;
  m_run.behind.add([this, now, kept] {
    now->scenario = to_toml(m_run.p);
    now->configuration_hash = configuration_hash(m_run.p);
    for (const Regular& regular : m_outputs)
      if (regular.output.flush) regular.output.flush();
    store::write_checkpoint(m_run.folder, *now, kept);
    m_safe_until = now->state.t;
  });
}

void RunFolder::see_last(const State& s, const Workspace& w) {
  for (const auto& [output, cadence] : m_outputs) {
    if (!output.write) continue;
    try {
      output.write(s, w);
    } catch (const NumericalFailure&) { // why the run has failed is known
    }
  }
}

std::vector<CellResult> RunFolder::finish(RunFinish end) {
  wait();
  end.cells = cell_results(end.s, m_run.memory.rows, m_run.memory.group, m_run.p);
  for (const auto& [output, cadence] : m_outputs)
    if (output.finish) output.finish(end);
  return std::move(end.cells);
}

void RunFolder::tidy() {
  for (const auto& [output, cadence] : m_outputs)
    if (output.remove_what_resuming_needs) output.remove_what_resuming_needs();
}

std::string RunFolder::text_of(const RunRecord& record) const {
  const auto handler = nlohmann::ordered_json::error_handler_t::replace;
  return to_json(record, m_run.p).dump(2, ' ', false, handler) + "\n";
}

void RunFolder::write_record(const RunRecord& record) const {
  m_run.behind.settle();
  write_file(m_run.folder / "run.json", text_of(record));
}

std::optional<double> RunFolder::safe_until() const {
  m_run.behind.settle();
  return m_safe_until;
}

std::string RunFolder::trajectory_hash() const { return store::TrajectoryHash(m_run.memory.trajectory).text(); }

store::LostFrames RunFolder::lost_frames() const {
  if (m_run.p.output.field_interval <= 0.0) return {};
  return store::lost_frames(m_run.memory.frames, m_run.frame_times);
}

} // namespace matrigrate::run
