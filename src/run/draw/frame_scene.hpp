#pragma once

#include "observe/cell_scene.hpp"
#include "observe/frame.hpp"

/// Stored frames as scenes to draw. Test: tests/unit/draw/figure_panel_test.cpp
namespace matrigrate::draw {

/// Positions of the matrix particles [um].
std::vector<Vec2> matrix_positions(const observe::FrameHead& head, const observe::Frame& frame);

/// The scene that observe::cell_scene() makes of the state of the frame; the front area of a cell ends at its last
/// particles.
/// @param paths  of the centre of mass of each cell so far; none: no paths [um]
observe::CellScene frame_scene(const observe::FrameHead& head, const observe::Frame& frame,
                               std::vector<std::vector<Vec2>> paths);

} // namespace matrigrate::draw
