#pragma once

#include "apps/simulate.hpp"
#include "store/checkpoint.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// A resumable run: its record and its checkpoints. Test: tests/apps/resume_test.cpp
namespace matrigrate::apps {

/// run.json of a folder; null where there is none, or it cannot be read.
nlohmann::ordered_json record_of(const std::filesystem::path& folder);

/// A text of a record; empty where there is none.
std::string text_of(const nlohmann::ordered_json& record, const char* key);

/// Whether a run is done: its record says so, and its checkpoint, if it is whole, does not say otherwise.
/// @param record  run.json of the folder
bool is_done(const std::filesystem::path& folder, const nlohmann::ordered_json& record);

/// The parameters of the run in a folder: scenario.resolved.toml or, with a warning, what its checkpoint holds.
/// @throws InputOutputError if neither can be read
Parameters scenario_of(const std::filesystem::path& folder);

/// Writes scenario.resolved.toml again, with a warning, if it is missing, incomplete or not valid and there is a whole
/// checkpoint to take it from.
void restore_scenario(const std::filesystem::path& folder);

/// The restarts and branches that a record tells of.
std::vector<nlohmann::ordered_json> lineage_of(const nlohmann::ordered_json& record);

/// A checkpoint that can be gone on with.
struct FoundCheckpoint {
  io::Checkpoint checkpoint;
  Parameters p;
  std::filesystem::path file;
};

/// @throws InputOutputError if the file is no whole checkpoint, or not one of the folder's scenario (as far as
///         scenario.resolved.toml or run.json can be read)
FoundCheckpoint read_checkpoint_of(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The last checkpoint, or the one before.
/// @throws InputOutputError if it cannot be gone on with, saying whether the one before can
FoundCheckpoint last_checkpoint(const std::filesystem::path& folder, bool previous);

/// The last checkpoint that is whole, for where nobody may be there to choose; says why if it is the one before.
/// @throws InputOutputError if neither is
FoundCheckpoint whole_checkpoint(const std::filesystem::path& folder);

/// Whether there are checkpoints.
bool has_checkpoint(const std::filesystem::path& folder);

/// Whether there are checkpoints, but none that is whole.
bool has_only_broken_checkpoints(const std::filesystem::path& folder);

/// Where a simulation goes on from a checkpoint.
Beginning beginning_of(const FoundCheckpoint& found, const nlohmann::ordered_json& record);

/// An entry of the lineage: "resumed" or "branched".
nlohmann::ordered_json event(std::string_view kind, const FoundCheckpoint& found);

/// The time of day, for the lineage.
std::string time_now();

/// Prints a warning.
void warn(std::string_view text);

/// Says so where another program has written it.
void tell_other_program(const FoundCheckpoint& found);

} // namespace matrigrate::apps
