#pragma once

#include "draw/cell_drawing.hpp"
#include "observe/cell_scene.hpp"

#include <span>
#include <string>

/// Pictures of the cell in its matrix. Test: tests/unit/draw/cell_picture_test.cpp
namespace matrigrate::draw {

/// One scene with its time, a scale bar and a legend.
/// @param box    what is seen: whole_disc() or surroundings()
/// @param width  [pixel] at least 240
/// @return  the SVG document
std::string cell_picture(const observe::CellScene& scene, const observe::Box& box, int width = 640);

/// Scenes side by side at one scale, with their times, a scale bar and a legend.
/// @param most  panels; of more scenes every second is shown, or every third and so on, and the last
/// @return  the SVG document
std::string contact_sheet(std::span<const observe::CellScene> scenes, std::size_t most = 12, int width = 760);

} // namespace matrigrate::draw
