#pragma once

#include "apps/simulate.hpp"

#include <filesystem>

namespace matrigrate::apps {

/// Whether a folder holds a run of these parameters, the number of threads aside, done or not.
bool holds_run(const std::filesystem::path& folder, const Parameters& p);

/// Goes on with the run in manner.folder from its last checkpoint; a run that is done is left as it is.
/// @param p  for the number of threads
/// @return the exit code
/// @throws InputOutputError if there is no checkpoint that can be gone on with, saying which one can
int go_on(const Manner& manner, const Parameters& p);

} // namespace matrigrate::apps
