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
/// @param film   with at least one frame
/// @param rows   of tracks.csv
/// @param title  of the run
std::string simularium(const observe::Film& film, std::span<const TrackRow> rows, const std::string& title,
                       const std::string& version);

} // namespace matrigrate::exchange
