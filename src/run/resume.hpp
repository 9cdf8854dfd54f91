#pragma once

#include "run/simulate.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Runs that were interrupted, and branches of runs: other parameters, another seed or another end from a moment on.
/// Test: tests/unit/run/simulate_test.cpp, tests/apps/resume_test.cpp
namespace matrigrate::run {

struct ResumeOptions {
  bool previous = false;      ///< from checkpoint_prev.h5, also if the run is done
  std::optional<int> threads; ///< none: as many as before
};

/// Resumes the run in options.folder from its last checkpoint, to the same bits as without the stop. A run that is
/// done is not changed.
/// @throws InputOutputError if the last checkpoint is not whole, saying whether the previous one is
RunOutcome resume(const RunOptions& options, const ResumeOptions& from, RunObserver& observer);

/// Resumes a run without asking a user: from its last whole checkpoint, or from the start if the run ended before its
/// first checkpoint.
/// @param p  the parameters of the run in the folder
/// @throws InputOutputError if there are checkpoints, but none that is whole
RunOutcome resume(const RunOptions& options, const Parameters& p, RunObserver& observer);

struct BranchOptions {
  std::vector<std::string> overrides; ///< "key=value"
  std::optional<double> at;           ///< simulated time; none: the last checkpoint [s]
  bool previous = false;              ///< without a time: at checkpoint_prev.h5
};

/// Begins a branch of the run in a folder, and computes it.
/// @param options  its folder is made here, and must not hold anything
/// @throws ConfigurationError, InputOutputError before anything is written
RunOutcome branch(const std::filesystem::path& from, const BranchOptions& how, const RunOptions& options,
                  RunObserver& observer);

// What stands in the folder of a run.

/// Whether a folder has the summary of a run, summary.json, which is written at the end.
bool has_summary(const std::filesystem::path& folder);

/// The parameters of the run in a folder: scenario.resolved.toml or, with a warning, what its checkpoint holds.
/// @throws InputOutputError if neither can be read
Parameters scenario_of(const std::filesystem::path& folder, RunObserver& observer);

/// Fingerprint, as this program makes it, of the parameters in scenario.resolved.toml of a folder; empty if the file is
/// missing, incomplete or not valid. Another version may have written another one into run.json.
std::string written_configuration(const std::filesystem::path& folder);

/// True if the folder holds a checkpoint.
bool has_checkpoint(const std::filesystem::path& folder);

/// True if the folder holds checkpoints, but none that is whole.
bool has_only_broken_checkpoints(const std::filesystem::path& folder);

} // namespace matrigrate::run
