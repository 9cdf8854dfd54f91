#pragma once

#include "draw/plot.hpp"

#include <string>
#include <vector>

/// The legend of a plot: outside of the axes, so that it never hides data. Test: tests/unit/draw/plot_test.cpp
namespace matrigrate::draw {

/// Colour of each series, as an index into the palette.
std::vector<int> series_colours(const std::vector<Series>& series);

/// Attributes of an SVG path, or of a group of paths, that give a line or dots their look.
std::string line_style(Mark mark, int colour);

/// Path data of one dot at (x, y): a shape for each colour, so that series differ by more than their colour.
std::string dot(double x, double y, int colour);

struct Legend {
  std::string svg;     ///< drawn with its upper left corner at (0, 0)
  double height = 0.0; ///< [pixel]
};

/// Entries side by side in rows not wider than `width` pixels.
Legend legend(const std::vector<Series>& series, double width);

} // namespace matrigrate::draw
