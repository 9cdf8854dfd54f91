#pragma once

#include "study_runs/study_folder.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// How far the runs of a study are that are being computed, from their files; nothing is written.
/// Test: tests/apps/study_test.cpp
namespace matrigrate::study {

/// A run that a process is computing.
struct RunningRun {
  std::size_t run;            ///< index into StudyFolder::runs
  double share;               ///< of the simulated time that is done [0 to 1], by its last row in tracks.csv
  std::optional<double> left; ///< wall time left at its mean pace so far; none before its second row [s]
};

struct StudyProgress {
  std::vector<RunningRun> running;
  std::optional<double>
      left; ///< wall time of all that is not done, at as many runs at a time as now; none if unknown [s]
};

/// @param standings  of all runs, in their order
StudyProgress progress_of(const StudyFolder& study, const std::vector<Standing>& standings);

} // namespace matrigrate::study
