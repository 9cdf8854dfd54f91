#pragma once

#include "base/vector.hpp"

#include <cstddef>
#include <vector>

/// Curves of equal value through a lattice of values. Test: tests/unit/draw/contour_test.cpp
namespace matrigrate::draw {

/// Values at the nodes of a square lattice, row by row from the lower left.
struct Lattice {
  Vec2 low = Vec2::Zero(); ///< where its first node lies [um]
  double step = 1.0;       ///< between nodes [um]
  std::size_t nx = 0, ny = 0;
  std::vector<double> value{}; ///< nx ny

  double at(std::size_t i, std::size_t j) const { return value[j * nx + i]; }
  Vec2 place(std::size_t i, std::size_t j) const {
    return low + step * Vec2(static_cast<double>(i), static_cast<double>(j));
  }
};

using Curve = std::vector<Vec2>; ///< closed; the last point is followed by the first [um]

/// The edges of the region where values are above a level, by marching squares (Lorensen and Cline 1987, in the plane),
/// with linear interpolation along the edges of the lattice. The region lies left of each curve, so holes have a
/// negative area. What reaches the border of the lattice is closed along it. Regions that touch at a corner are apart.
/// @throws std::invalid_argument if there are not nx ny values, or fewer than two nodes a side
std::vector<Curve> contours(const Lattice& lattice, double level);

/// Area that a closed curve goes around anticlockwise [um^2].
double enclosed(const Curve& curve);

} // namespace matrigrate::draw
