#pragma once

#include <cstddef>
#include <string_view>

/// Colours that tell cells apart; the viewer has the same (viewer/src/colour.ts).
/// Test: tests/unit/draw/cell_picture_test.cpp
namespace matrigrate::draw {

/// The front of a cell is lighter than its rear.
struct CellColours {
  std::string_view rear;
  std::string_view front;
};

/// Number of colours for several cells; they repeat beyond, and the cells' numbers tell those apart.
inline constexpr std::size_t cell_colour_count = 8;

/// @param cell   index of the cell   @param cells  how many there are; a single one has colours of its own
CellColours cell_colours(std::size_t cell, std::size_t cells);

} // namespace matrigrate::draw
