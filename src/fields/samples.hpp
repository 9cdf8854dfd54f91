#pragma once

#include "base/vector.hpp"
#include "fields/picture.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Numbers over the plane as samples on a regular grid. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

/// Values at the nodes of a grid, bilinear between them and constant beyond its border.
struct Samples {
  Vec2 origin = Vec2::Zero();  ///< of the first node [um]
  Vec2 spacing = Vec2::Ones(); ///< between nodes along x and y, > 0 [um]
  std::size_t columns = 0, rows = 0;
  std::vector<double> values; ///< row by row, upwards; columns * rows of them
  std::string column{};       ///< that the values are from, of a CSV file
  bool axes = false;          ///< the values are directions without a sense [degrees]: 90 is -90

  double at(const Vec2& x) const;

  /// The direction without a sense, where the nodes have those of from + per_value * value [degrees], in (-90, 90].
  double axis_at(const Vec2& x, double from, double per_value) const;

  Vec2 end() const; ///< of the last node [um]
};

/// A grid from CSV with a header line: columns x_um and y_um, and the one named, or the third; a row per node of a
/// regular grid, in any order. Memory and time grow as the text does.
/// @throws std::invalid_argument saying what is wrong: no such column, no commas, no number, no regular grid, a node
/// missing or twice
Samples samples_from_csv(std::string_view csv, std::string_view column);

/// A picture with a node in the middle of each pixel, as (sample - zero) / (one - zero).
/// @param pixel   width of a pixel [um], > 0
/// @param centre  where the picture's centre lies [um]
Samples samples_from_picture(const Picture& picture, double pixel, const Vec2& centre, double zero, double one);

} // namespace matrigrate::fields
