#pragma once

#include "run/simulate.hpp"

#include <filesystem>
#include <optional>

/// Runs that were interrupted. Test: tests/unit/run/simulate_test.cpp, tests/apps/resume_test.cpp
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

} // namespace matrigrate::run
