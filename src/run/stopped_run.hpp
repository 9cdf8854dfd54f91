#pragma once

#include "run/simulate.hpp"
#include "store/checkpoint.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <string_view>

/// A resumable run: its record and its checkpoints. Test: tests/apps/resume_test.cpp
namespace matrigrate::run {

/// Whether a folder has the summary of a run, summary.json, which is written at the end.
bool has_summary(const std::filesystem::path& folder);

/// True if a run is done: its record says so, and its checkpoint, if whole, does not contradict, nor is its summary
/// gone.
/// @param record  run.json of the folder
bool is_done(const std::filesystem::path& folder, const Json& record, RunObserver& observer);

/// The parameters of the run in a folder: scenario.resolved.toml or, with a warning, what its checkpoint holds.
/// @throws InputOutputError if neither can be read
Parameters scenario_of(const std::filesystem::path& folder, RunObserver& observer);

/// Fingerprint, as this program makes it, of the parameters in scenario.resolved.toml of a folder; empty if the file is
/// missing, incomplete or not valid. Another version may have written another one into run.json.
std::string written_configuration(const std::filesystem::path& folder);

/// Writes scenario.resolved.toml again, with a warning, if it is missing, incomplete or not valid and there is a whole
/// checkpoint to take it from.
void restore_scenario(const std::filesystem::path& folder, RunObserver& observer);

/// A checkpoint that a run can be resumed from.
struct FoundCheckpoint {
  store::Checkpoint checkpoint;
  store::RunMemory memory;
  Parameters p;
  std::filesystem::path file;
};

/// @throws InputOutputError if the file is no whole checkpoint, or not one of the folder's scenario (as far as
///         scenario.resolved.toml or run.json can be read), or if the folder's tables are not those it was written with
FoundCheckpoint read_checkpoint_of(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The last checkpoint, or the one before.
/// @throws InputOutputError if the run cannot be resumed from this checkpoint, saying whether the previous one can
FoundCheckpoint last_checkpoint(const std::filesystem::path& folder, bool previous);

/// The last whole checkpoint, chosen without asking a user; warns, with the reason, if it is the previous one.
/// @throws InputOutputError if neither checkpoint is whole
FoundCheckpoint whole_checkpoint(const std::filesystem::path& folder, RunObserver& observer);

/// Whether a checkpoint holds the end of a run that ended within a step. A longer run does not pass this state.
bool is_shortened_end(const FoundCheckpoint& found);

/// The checkpoint, or in place of a shortened end the one before it, as far as that can be read.
FoundCheckpoint before_shortened_end(FoundCheckpoint found, const std::filesystem::path& folder);

/// True if the folder holds a checkpoint.
bool has_checkpoint(const std::filesystem::path& folder);

/// True if the folder holds checkpoints, but none that is whole.
bool has_only_broken_checkpoints(const std::filesystem::path& folder);

/// A start from a checkpoint.
RunStart start_from(const FoundCheckpoint& found, const Json& record);

/// An entry of the lineage: "resumed" or "branched".
Json event(std::string_view kind, const FoundCheckpoint& found);

/// Warns if another version of the program wrote the checkpoint: that bits may differ, or that its model is another.
void warn_of_other_program(const FoundCheckpoint& found, RunObserver& observer);

/// @throws ConfigurationError if the run in a folder has readings that this program does not compute (Origin::gone)
void require_computable(const Parameters& p, const std::filesystem::path& folder);

} // namespace matrigrate::run
