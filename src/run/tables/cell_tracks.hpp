#pragma once

#include "tracks/options.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The paths of the cells of a run, and those of measured cells. Test: tests/unit/study_plan/targets_test.cpp
namespace matrigrate::tracks {

/// The rows of tracks.csv that belong to one cell, in the order of time.
struct CellTrack {
  std::uint32_t cell = 1; ///< number of the cell
  std::vector<double> t;  ///< [s]
  std::vector<double> x;  ///< centre of mass [um]
  std::vector<double> y;
};

/// @param run_folder  with tracks.csv
/// @return  a track for each cell, in the order in which they first occur
/// @throws InputOutputError if tracks.csv cannot be read, or has no times or places
std::vector<CellTrack> cell_tracks(const std::filesystem::path& run_folder);

/// What measured tracks are wanted for.
enum class TracksFor {
  drawing, ///< any tracks
  readouts ///< two tracks without gaps, since a mean needs an error, and a read-out of a run all its rows
};

/// Measured tracks as those of a run. Times count from the start of each track.
/// @param notes  get what the reader has to tell
/// @throws InputOutputError if the file cannot be read
/// @throws ConfigurationError with all faults
std::vector<CellTrack> measured_tracks(const std::filesystem::path& file, TrackOptions options, TracksFor use,
                                       std::vector<std::string>& notes);

/// A file of these tracks, from which measured_tracks() reads the same numbers.
std::string measured_csv(const std::vector<CellTrack>& tracks);

/// Read-outs of a run that its path alone defines: those that measured tracks have too.
const std::vector<std::string>& readouts_of_tracks();

/// One of them, as of a run with this path; NaN where it is not defined.
double readout_of(const CellTrack& track, std::string_view readout);

} // namespace matrigrate::tracks
