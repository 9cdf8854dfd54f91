#pragma once

#include "study_runs/study_folder.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// What a study takes. Test: tests/unit/study_runs/study_folder_test.cpp
namespace matrigrate::study {

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
