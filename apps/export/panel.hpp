#pragma once

#include "exchange/run_tracks.hpp"
#include "run/finished_run.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace matrigrate::apps {

/// The times of the frames of a run nearest to those of --panel [s].
/// @param times  "0 h, 1 h 30 min, 6 h"
/// @throws UsageError saying what cannot be read, or which time has no frame nearby
std::vector<double> panel_times(const run::FinishedRun& run, const std::string& times);

/// The numbers of the frames nearest to those of --times, each once; all without times.
/// @throws UsageError saying which time has no frame nearby
std::vector<std::size_t> frames_at(const run::FinishedRun& run, const exchange::Times& times);

} // namespace matrigrate::apps
