#pragma once

#include "study_runs/study_folder.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace matrigrate::study {

/// How the runs of a study are computed: as many processes of this program at a time as `jobs`, each with one run.
struct PoolOptions {
  int jobs = 1;
  int threads = 1;           ///< of each process; more where there are fewer runs than jobs
  bool retry_failed = false; ///< also those that failed numerically before
};

/// A run that is not done, and why.
struct Trouble {
  std::size_t run; ///< index into StudyFolder::runs
  RunState status;
  std::string reason;
};

struct PoolOutcome {
  std::size_t done_before = 0;
  std::size_t done_now = 0;
  std::vector<Trouble> troubles;
  int signal = 0;               ///< that stopped the pool, or 0
  bool cannot_write = false;    ///< a run could not write its files: the pool was stopped
  bool ended_by_signal = false; ///< a run was ended by a signal that the pool did not pass on
};

/// Follows a pool from outside: called before the first run is started, and then many times a second.
/// @param runs  that are to be computed   @param ended  of them   @param failed  those of them that are not done
/// @return a signal that is passed on to the runs and stops the pool, or 0
using PoolWatch = std::function<int(std::size_t runs, std::size_t ended, std::size_t failed)>;

/// Computes the given runs that are not done, in their order. A run that fails does not stop the others. A run that
/// cannot write its files stops them, and so does a signal that the watch returns. Test: tests/apps/study_test.cpp
PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const PoolOptions& options,
                    const PoolWatch& watch);

} // namespace matrigrate::study
