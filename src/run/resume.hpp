#pragma once

#include "run/simulate.hpp"

#include <filesystem>
#include <optional>

/// Runs that were interrupted. Test: tests/unit/run/simulate_test.cpp, tests/apps/resume_test.cpp
namespace matrigrate::run {

/// Whether a folder holds a run of these parameters, the number of threads aside, done or not.
bool holds_run(const std::filesystem::path& folder, const Parameters& p);

struct ResumeOptions {
  bool previous = false;      ///< from checkpoint_prev.h5, also if the run is done
  std::optional<int> threads; ///< none: as many as before
};

/// Resumes the run in options.folder from its last checkpoint, to the same bits as if it had never stopped; a run that
/// is done is left as it is.
/// @throws InputOutputError if there is no whole checkpoint, saying whether the one before is
RunOutcome resume(const RunOptions& options, const ResumeOptions& from, RunObserver& observer);

/// The same for where nobody may be there to choose: from its last whole checkpoint, or from the start if it was ended
/// before its first one.
/// @param p  the parameters of the run in the folder
/// @throws InputOutputError if there are checkpoints, but none that is whole
RunOutcome resume(const RunOptions& options, const Parameters& p, RunObserver& observer);

} // namespace matrigrate::run
