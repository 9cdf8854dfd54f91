#include "draw/cell_colours.hpp"

#include <array>

namespace matrigrate::draw {

CellColours cell_colours(std::size_t cell, std::size_t cells) {
  constexpr CellColours single{"#0072b2", "#45c4b8"};
  constexpr std::array<CellColours, cell_colour_count> several{{{"#0072b2", "#73b9e2"},
                                                                {"#1b7837", "#7fc78d"},
                                                                {"#7b3294", "#c2a5cf"},
                                                                {"#8a4f14", "#dfc27d"},
                                                                {"#b2182b", "#f09c8c"},
                                                                {"#01665e", "#5ab4ac"},
                                                                {"#4d4d4d", "#b0b0b0"},
                                                                {"#c51b7d", "#f1b6da"}}};
  return cells > 1 ? several[cell % cell_colour_count] : single;
}

} // namespace matrigrate::draw
