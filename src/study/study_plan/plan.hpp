#pragma once

#include "study_plan/study.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/// The runs of a study. Test: tests/unit/study_plan/plan_test.cpp
namespace matrigrate::study {

/// One run.
struct Run {
  std::size_t point = 0;     ///< index into Study::points
  std::size_t replicate = 1; ///< from 1
  std::uint64_t seed = 0;
  std::string hash; ///< of all that decides on its results: the name of its folder
};

/// The seed of a run: a hash of the study's seed, the settings of the point, sorted by key, and the replicate. So a run
/// keeps its seed whatever points and replicates are added, left out or put in another order.
/// @param settings  empty for common random numbers
/// @return at most 2^53 - 1, which every reader of JSON keeps
std::uint64_t run_seed(std::uint64_t study_seed, std::vector<Setting> settings, std::size_t replicate);

/// The seed of a run where the settings of its point are taken as they were typed, as versions did that took two
/// spellings of a law for two points. The seed of a run follows from their meaning (meant()).
std::uint64_t seed_as_typed(const Study& study, const Run& run);

/// The parameters of a run: those of its point, with its seed and one thread.
Parameters parameters_of(const Study& study, const Run& run);

/// A fingerprint of all parameters that decide on a run's results.
using Fingerprint = std::function<std::string(const Parameters&)>;

/// All runs, replicate by replicate, so that a study that is stopped early has something of every point.
std::vector<Run> planned_runs(const Study& study, const Fingerprint& fingerprint);

} // namespace matrigrate::study
