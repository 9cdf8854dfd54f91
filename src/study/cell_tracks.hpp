#pragma once

#include <filesystem>
#include <vector>

/// The paths of the cells of a run. Test: tests/unit/study/table_readouts_test.cpp
namespace matrigrate::study {

/// The rows of tracks.csv that belong to one cell, in the order of time.
struct CellTrack {
  double cell = 1.0;     ///< number of the cell
  std::vector<double> t; ///< [s]
  std::vector<double> x; ///< centre of mass [um]
  std::vector<double> y;
};

/// @param run_folder  with tracks.csv
/// @return  a track for each cell, in the order in which they first occur
/// @throws InputOutputError if tracks.csv cannot be read, or has no times or places
std::vector<CellTrack> cell_tracks(const std::filesystem::path& run_folder);

} // namespace matrigrate::study
