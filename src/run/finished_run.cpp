#include "run/finished_run.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "observe/readout_table.hpp"
#include "parameters/read.hpp"
#include "report/run_page.hpp"
#include "run/folder_state.hpp"
#include "run/run_record.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"
#include "tables/run_files.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <variant>

namespace matrigrate::run {

namespace {

/// How the run stands, in a sentence.
std::string status_text(const FinishedRun& run) {
  const std::string status = run.record.value("status", "unknown");
  const std::string reason = run.record.value("reason", "");
  const std::string reached = fmt::format("{} of {}", time_text(run.t), time_text(run.p.run.duration));
  const store::LostFrames lost = lost_frames(run);
  const std::string gone = lost.count == 0 ? "" : fmt::format(" {}.", store::to_text(lost));
  if (status_of(run.record) == RunStatus::done) return fmt::format("Done: {}.{}", time_text(run.t), gone);
  return fmt::format("Status: {}; {} in the last checkpoint{}{}.{}", status, reached, reason.empty() ? "" : ": ",
                     reason, gone);
}

/// The program and machine behind the numbers, as in run.json.
std::string provenance_of(const Json& record) {
  std::string text;
  for (const char* key : {"version", "git_hash", "compiler", "build_type", "flags", "start", "end", "trajectory_hash"})
    if (const std::string value = text_of(record, key); !value.empty()) text += fmt::format("{:<17}{}\n", key, value);
  return text;
}

/// True if a run came to its end, or was stopped, at t. It then wrote a frame at t, due or not.
bool ended_at(const Json& record, double t) {
  const std::optional<RunStatus> status = status_of(record);
  return (status == RunStatus::done || status == RunStatus::interrupted) && number_in(record, "t_s") == t;
}

/// A checkpoint; where it is damaged, tells whether the one before is whole.
store::Checkpoint checkpoint_in(const std::filesystem::path& folder, const std::filesystem::path& file) {
  try {
    return store::read_checkpoint(file);
  } catch (const InputOutputError& trouble) {
    const std::filesystem::path before = folder / store::previous_checkpoint_name;
    std::string offer;
    try {
      if (file != before)
        offer = fmt::format("; {}, at {}, is whole: move {} away to use it", store::previous_checkpoint_name,
                            time_text(store::read_checkpoint(before).state.t), store::checkpoint_name);
    } catch (const InputOutputError&) { // neither is
    }
    throw InputOutputError(trouble.what() + offer);
  }
}

constexpr std::size_t largest_table = std::size_t{1} << 28U;

/// What is made of the text of a table. @throws InputOutputError naming it
template <class Read>
auto from_table(const std::filesystem::path& file, const Read& read) {
  const std::string text = read_file(file, largest_table);
  return naming(file, [&] { return read(text); });
}

/// f_adh_rel of the protrusions of each cell.
std::vector<std::vector<double>> forces_of(const std::string& protrusions, std::size_t cells) {
  const std::vector<double> force = store::csv_columns(protrusions, {"id", "f_adh_rel"})[1];
  const std::vector<double> cell = store::csv_column(protrusions, "cell");
  std::vector<std::vector<double>> forces(cells);
  for (std::size_t k = 0; k < force.size(); ++k)
    for (std::size_t id = 0; id < cells; ++id)
      if (cell.empty() || cell[k] == static_cast<double>(id + 1)) forces[id].push_back(force[k]);
  return forces;
}

std::vector<CellResult> cells_in(const std::filesystem::path& folder) {
  const std::vector<TrackRow> rows = from_table(folder / "tracks.csv", store::track_rows_of);
  std::uint32_t count = 0;
  for (const TrackRow& row : rows) count = std::max(count, matrigrate::number_of(row.cell));
  const auto forces =
      from_table(folder / "protrusions.csv", [&](const std::string& text) { return forces_of(text, count); });
  std::vector<CellResult> cells;
  for (std::uint32_t id = 0; id < count; ++id) {
    CellResult& cell = cells.emplace_back(CellResult{.cell = id, .rows = rows_of(rows, id)});
    cell.readouts = readouts(cell.rows, {}, Parameters());
    cell.readouts.share_low_force = share_of_low_forces(forces[id]);
  }
  if (count > 1) add_group(cells, from_table(folder / "group.csv", store::group_rows_of));
  return cells;
}

} // namespace

FinishedRun read_run(const std::filesystem::path& folder) {
  std::error_code error;
  require(look_at(folder), Use::see_run);
  FinishedRun run;
  run.folder = folder;
  run.record = read_record(folder);
  const bool last = std::filesystem::exists(folder / store::checkpoint_name, error);
  const std::filesystem::path file = folder / (last ? store::checkpoint_name : store::previous_checkpoint_name);
  const store::Checkpoint checkpoint = checkpoint_in(folder, file);
  run.p = parse_parameters(checkpoint.scenario, file.string());
  run.t = checkpoint.state.t;
  run.memory = store::parse_memory(checkpoint.memory, folder);
  if (run.memory.rows.empty() || run.memory.rows.back().step != checkpoint.state.step)
    std::ranges::copy(track_rows(checkpoint.state),
                      std::back_inserter(run.memory.rows)); // as at the end of a run
  run.cells = cell_results(checkpoint.state, run.memory.rows, run.memory.group, run.p);
  run.frame_times = run.memory.frames;
  if (ended_at(run.record, run.t) && (run.frame_times.empty() || run.frame_times.back() < run.t))
    run.frame_times.push_back(run.t);
  const store::FrameShape shape{.head = observe::frame_head(checkpoint.state, run.p),
                                .outline = cortex_particles(checkpoint.state),
                                .fibres = run.p.fibres.arrangement != FibreArrangement::none};
  if (run.p.output.field_interval > 0.0) run.film = store::saved_film(folder, shape, run.frame_times, &run.trouble);
  return run;
}

store::LostFrames lost_frames(const FinishedRun& run) {
  if (run.p.output.field_interval <= 0.0) return {};
  const std::vector<double> there = observe::times_of(run.film);
  std::vector<double> written;
  std::ranges::set_union(run.frame_times, there, std::back_inserter(written));
  return store::lost_frames(written, there);
}

nlohmann::ordered_json page_data(const FinishedRun& run) {
  const std::string scenario = scenario_name(run.record, run.folder);
  return report::run_data({.title = run_title(run.p, scenario),
                           .status = status_text(run),
                           .facts = run_facts(run.p, run.record, scenario),
                           .t_end = run.t,
                           .p = run.p,
                           .cells = run.cells,
                           .health = run.memory.tables.at("health.csv"),
                           .film = &run.film,
                           .provenance = provenance_of(run.record)});
}

void add_from_tables(const std::filesystem::path& folder, std::span<double> values) {
  const std::vector<CellResult> cells = cells_in(folder);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const ReadOutSpec& spec = readout_table()[k];
    if (!spec.of_claims) continue;
    double sum = 0.0;
    double defined = 0.0;
    for (const CellResult& cell : cells) {
      const double value = std::get<double>(spec.value(cell.readouts));
      if (std::isnan(value)) continue;
      sum += value;
      defined += 1.0;
    }
    values[k] = defined > 0.0 ? sum / defined : undefined;
  }
}

} // namespace matrigrate::run
