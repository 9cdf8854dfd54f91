#pragma once

#include "base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Fast search for points near a place: a vectorised bounding-box test that skips whole blocks of points. Test:
/// tests/unit/base/base_test.cpp
namespace matrigrate {

/// A rectangle along the axes [um].
struct Box {
  Vec2 low, high;
};

/// The square of half width `reach` around a point, enlarged by more than the rounding error of a distance.
Box around(const Vec2& point, double reach);

/// The same box without bounds along x, for points that are periodic along x.
Box unbounded_along_x(Box box);

/// Indices of the points in a box or on its edge, in ascending order.
std::vector<std::uint32_t> points_in(const Box& box, std::span<const Vec2> points);

/// Sets a mark per point: 1 in the box or on its edge, else 0.
void mark_points_in(const Box& box, std::span<const Vec2> points, std::uint8_t* marks);

/// The first index from `from` on whose mark is 1; the number of marks if there is none.
std::size_t next_marked(std::span<const std::uint8_t> marks, std::size_t from);

} // namespace matrigrate
