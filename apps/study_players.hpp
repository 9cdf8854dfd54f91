#pragma once

#include "apps/study_folder.hpp"
#include "study/study_data.hpp"

#include <string>
#include <vector>

namespace matrigrate::apps {

/// The runs that a study's page plays, with so few frames that the page stays below 15 MB.
/// @param wanted  names of their folders; none: of up to five points the run in the middle by the first read-out
/// @throws UsageError if a wanted run is none of the study, or is not done; others that cannot be read are left out
/// Test: tests/apps/study_test.cpp
std::vector<study::PlayedRun> played_runs(const StudyFolder& study, const std::vector<study::Result>& results,
                                          const std::vector<std::string>& wanted);

} // namespace matrigrate::apps
