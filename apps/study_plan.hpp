#pragma once

#include "apps/study_folder.hpp"

#include <cstddef>

namespace matrigrate::apps {

/// What a study will take, before anything is computed.
struct StudyCost {
  double wall_time = 0.0;        ///< of all runs, one after the other, one thread each [s]
  double memory_bytes = 0.0;     ///< of the largest run
  double disk_bytes = 0.0;       ///< of all runs
  std::vector<double> run_times; ///< of a run at each point [s]
  std::size_t looked_at = 0;     ///< points that warnings were looked for at
  std::vector<std::string> warnings;
};

StudyCost cost(const StudyFolder& study);

/// Points, runs and cost, in words or as JSON.
int print_plan(const StudyFolder& study, int jobs, bool json);

} // namespace matrigrate::apps
