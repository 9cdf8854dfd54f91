#pragma once

#include "study_runs/pool.hpp"

#include <string>
#include <vector>

/// A pool on the terminal. Test: tests/apps/study_test.cpp
namespace matrigrate::apps {

struct ShownPoolOptions {
  int jobs = 1;
  int threads = 1;           ///< of each process
  bool retry_failed = false; ///< also those that failed numerically before
  bool quiet = false;        ///< show no progress
};

/// Computes the given runs that are not done, as study::compute does; signals to this program stop it, and the
/// standard error shows how far it is.
study::PoolOutcome compute(const study::StudyFolder& study, const std::vector<std::size_t>& runs,
                           const ShownPoolOptions& options);

int exit_code(const study::PoolOutcome& outcome);

/// Every run that is not done, with its reason: "failed  50 Pa, replicate 3 (0123...): reason".
std::string troubles_text(const study::StudyFolder& study, const std::vector<study::Trouble>& troubles);

} // namespace matrigrate::apps
