#pragma once

#include "study_report/study_data.hpp"
#include "study_runs/study_folder.hpp"

#include <string>
#include <vector>

namespace matrigrate::study {

/// Why a wanted run cannot be played: it is not of this study, or is not done; empty if all wanted runs can.
/// @param wanted  names of the folders of runs
std::string fault_of_wanted(const std::vector<Result>& results, const std::vector<std::string>& wanted);

/// The runs that a study's page plays, with so few frames that the page stays below 15 MB.
/// @param wanted  names of their folders; none: of up to five points the run in the middle by the first read-out
/// @param tracks  measured, to be drawn besides those of the targets
/// @throws std::invalid_argument if a wanted run is none of the study, or is not done (fault_of_wanted)
/// @throws InputOutputError if a wanted run cannot be read; other unreadable runs are left out
/// Test: tests/apps/study_test.cpp
std::vector<PlayedRun> played_runs(const StudyFolder& study, const std::vector<Result>& results,
                                   const std::vector<std::string>& wanted,
                                   const std::vector<tracks::CellTrack>& tracks = {});

} // namespace matrigrate::study
