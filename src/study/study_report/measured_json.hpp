#pragma once

#include "study_plan/study.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <vector>

/// Measured tracks as pages draw them over simulated ones (MeasuredTracks of viewer/src/contract.ts).
/// Test: tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// Tracks from a common origin and from time 0: of more than 200 as many, of each at most 100 positions, evenly chosen.
/// @return null without tracks
nlohmann::ordered_json measured_json(const std::vector<tracks::CellTrack>& tracks);

/// The tracks of the targets that hold at a point, and further ones.
std::vector<tracks::CellTrack> tracks_at(const Study& study, const std::vector<tracks::CellTrack>& further,
                                         std::size_t point);

/// The tracks of each file that targets name, and further ones, with the places of the points that they belong to.
/// @param places  of the points in the grid of the page
nlohmann::ordered_json measured_json(const Study& study, const std::vector<tracks::CellTrack>& further,
                                     const std::vector<nlohmann::ordered_json>& places);

} // namespace matrigrate::study
