#pragma once

#include "observe/frame.hpp"
#include "observe/tracks.hpp"

#include <span>
#include <string>

/// Frames for Simularium's viewer. Test: tests/unit/exchange/simularium_test.cpp, tests/readers/simularium/open.mjs
namespace matrigrate::exchange {

/// A trajectory in Simularium's JSON format, version 3; um and s. Its agents are the cells and nuclei as closed fibres,
/// the adhesions and the particles of the matrix as spheres; particles of fluid are in the state "degraded". Plots show
/// the way of each cell.
/// The viewer supposes frames of one interval: a last one that comes too soon is left out.
/// @param film   with at least one frame
/// @param rows   of tracks.csv
/// @param title  of the run
/// @throws std::invalid_argument if the frames are not evenly spaced otherwise
std::string simularium(const observe::Film& film, std::span<const TrackRow> rows, const std::string& title,
                       const std::string& version);

/// Whether the viewer can show all frames but the last one.
bool fits_simularium(const observe::Film& film);

} // namespace matrigrate::exchange
