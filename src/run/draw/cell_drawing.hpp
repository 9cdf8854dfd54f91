#pragma once

#include "observe/cell_scene.hpp"

#include <cstddef>
#include <string>

/// The pieces of which pictures of the cell are made. Test: tests/unit/draw/cell_picture_test.cpp
namespace matrigrate::draw {

inline constexpr double room_around_cell = 12.0; ///< [um]
inline constexpr double scale_bar_height = 30.0; ///< of the line with the scale bar [pixel]

/// Where a scene is drawn.
struct Panel {
  observe::Box box;  ///< what is seen of the plane; a square [um]
  double left = 0.0; ///< [pixel]
  double top = 0.0;  ///< [pixel]
  double side = 0.0; ///< [pixel]

  double scale() const { return side / box.size().x(); } ///< [pixel/um]
  Vec2 at(const Vec2& x) const {
    return {left + scale() * (x.x() - box.low.x()), top + scale() * (box.high.y() - x.y())};
  }
};

/// Matrix, cells, protrusions, adhesions and paths, cut off at the panel's frame.
std::string drawing(const observe::CellScene& scene, const Panel& panel);

/// A bar of a round length and its length in um.
/// @param x, y  upper left corner [pixel]
/// @param most  largest length of the bar [pixel]
std::string scale_bar(double x, double y, double most, const Panel& panel);

/// What the colours mean.
struct CellLegend {
  std::string svg;     ///< with its upper left corner at (0, 0)
  double height = 0.0; ///< [pixel]
};

/// @param scene  whose cells and obstacles are to be told apart
CellLegend cell_legend(double width, const observe::CellScene& scene);

} // namespace matrigrate::draw
