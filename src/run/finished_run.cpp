#include "run/finished_run.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/read.hpp"
#include "report/run_page.hpp"
#include "run/folder_state.hpp"
#include "run/run_record.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

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

} // namespace matrigrate::run
