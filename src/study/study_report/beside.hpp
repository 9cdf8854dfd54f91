#pragma once

#include "tracks/read_tracks.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// Measured cells beside simulated ones, on one page. Test: tests/unit/study_report/beside_test.cpp
namespace matrigrate::study {

/// Cells that are compared as one sample.
struct CellGroup {
  std::string label;
  tracks::Tracks tracks;
};

/// How simulated cells are looked at, so that they can stand beside measured ones.
struct Microscope {
  double interval = 60.0; ///< between positions [s]
  double duration = 0.0;  ///< what is left of longer paths, from their start [s]
  double error = 0.0;     ///< standard deviation of the error that is added to a coordinate [um]
};

/// The cells of a run, or of each point of a study, from its runs that are done, as the microscope sees them.
/// @throws InputOutputError if a table cannot be read
/// @throws ConfigurationError if no run is done, the interval is no whole multiple of output.track_interval, or the
///         study has more points than a page can show
std::vector<CellGroup> simulated_cells(const std::filesystem::path& folder, const Microscope& microscope);

/// Leaves of longer tracks what comes within the duration [s]. @return intervals in it
std::size_t cut(tracks::Tracks& cells, double duration);

/// Half of the tracks last longer [s].
double usual_duration(const std::vector<CellGroup>& groups);

/// @throws ConfigurationError with all that keeps the groups from being compared: other intervals, the same positions
///         twice
void require_comparable(const std::vector<CellGroup>& groups);

/// The data of a page of the template of studies (viewer/src/study/contract.ts), a track in place of a run: read-outs
/// of each, medians with bootstrap intervals of 95 %, Mann and Whitney's test of each pair of groups after Holm, mean
/// square displacements with bootstrap errors, and paths.
/// @param groups  the measured ones first, and then simulated ones, seen by the microscope
nlohmann::ordered_json beside_data(const std::vector<CellGroup>& groups, const Microscope& microscope);

} // namespace matrigrate::study
