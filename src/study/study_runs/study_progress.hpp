#pragma once

#include "study_runs/study_folder.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::study {

// How far the runs of a study are that are being computed, from their files; nothing is written.
// Test: tests/apps/study_test.cpp

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

// What a study takes. Test: tests/unit/study_runs/study_folder_test.cpp

/// Estimated cost of a study, before anything is computed.
struct StudyCost {
  double wall_time = 0.0;        ///< of all runs, one after the other, one thread each [s]
  double memory_bytes = 0.0;     ///< of the largest run
  double disk_bytes = 0.0;       ///< of all runs
  std::vector<double> run_times; ///< of a run at each point [s]
  std::size_t looked_at = 0;     ///< points that warnings were looked for at
  std::vector<std::string> warnings;
};

StudyCost cost(const StudyFolder& study);

} // namespace matrigrate::study
