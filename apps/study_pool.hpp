#pragma once

#include "apps/study_folder.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// How the runs of a study are computed: as many processes of this program at a time as `jobs`, each with one run.
struct PoolOptions {
  int jobs = 1;
  int threads = 1;           ///< of each process
  bool retry_failed = false; ///< also those that failed numerically before
  bool quiet = false;
};

/// A run that is not done, and why.
struct Trouble {
  std::size_t run; ///< index into StudyFolder::runs
  study::RunState status;
  std::string reason;
};

struct PoolOutcome {
  std::size_t done_before = 0;
  std::size_t done_now = 0;
  std::vector<Trouble> troubles;
  int signal = 0;               ///< that stopped the pool, or 0
  bool cannot_write = false;    ///< a run could not write its files: the pool was stopped
  bool ended_by_signal = false; ///< a run was ended by a signal that the pool did not pass on

  int exit_code() const;
};

/// Computes those of the given runs that are not done, in their order. A run that fails does not stop the others; one
/// that cannot write its files does, and so does a signal to this program, which is passed on to the runs.
PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const PoolOptions& options);

} // namespace matrigrate::apps
