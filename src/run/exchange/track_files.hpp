#pragma once

#include "observe/tracks.hpp"

#include <span>
#include <string>

/// The paths of the cells for programs that analyse tracks. Test: tests/unit/exchange/tracks_test.cpp,
/// tests/readers/tracks_reads.py
namespace matrigrate::exchange {

/// For celltrackR: columns id, t [s], x, y [um]. Read by read.tracks.csv(file, sep = ",", pos.columns = 3:4).
std::string celltrackr_csv(std::span<const TrackRow> rows);

/// As TrackMate exports spots: columns ID, TRACK_ID, POSITION_X, POSITION_Y, POSITION_Z [um], POSITION_T [s], FRAME,
/// RADIUS [um]; without FRAME, which counts frames of one interval, where the rows are not evenly spaced.
std::string trackmate_csv(std::span<const TrackRow> rows);

/// As TrackMate exports tracks to XML ("Export tracks to XML file"), one particle a cell; a detection's t is the number
/// of its row, as TrackMate's is that of the frame.
/// @throws std::invalid_argument if the rows are not evenly spaced
std::string trackmate_xml(std::span<const TrackRow> rows);

} // namespace matrigrate::exchange
