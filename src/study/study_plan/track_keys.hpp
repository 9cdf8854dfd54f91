#pragma once

#include "study_plan/fault_list.hpp"
#include "tracks/options.hpp"

#include <string>
#include <vector>

/// How a file of measured tracks is to be read, from keys beside `tracks = "FILE"`. Test:
/// tests/unit/study_plan/targets_test.cpp
namespace matrigrate::study {

/// "pixel", "interval", "time_unit", "columns", "layout", "splits", "jitter", "recalibrate", "shortest".
const std::vector<std::string>& track_keys();

/// @param section  of the keys: "targets"
/// Faults go to `faults`.
tracks::TrackOptions read_track_keys(const toml::table& table, const std::string& section, FaultList& faults);

} // namespace matrigrate::study
