#pragma once

#include "run/finished_run.hpp"

#include <string>
#include <vector>

namespace matrigrate::apps {

/// The times of the frames of a run nearest to some times [s].
/// @param times  "0 h, 1 h 30 min, 6 h"; a number without a unit is hours
/// @throws UsageError saying what cannot be read, or which time has no frame nearby
std::vector<double> frames_at(const run::FinishedRun& run, const std::string& times);

} // namespace matrigrate::apps
