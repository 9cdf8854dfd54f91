#pragma once

#include "base/vector.hpp"

#include <cstddef>
#include <filesystem>
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

  double at(const Vec2& x) const;
  Vec2 end() const; ///< of the last node [um]
};

/// A grid from CSV with a header line: columns x_um and y_um, and the one named, or the third; a row per node of a
/// regular grid, in any order.
/// @throws std::invalid_argument saying what is wrong: no such column, no number, no regular grid, a node missing or
/// twice
Samples samples_from_csv(std::string_view csv, std::string_view column);

/// The grey of a PNG or TIFF picture: 0 black to 1 white; colours by their brightness. Pixel (0, 0) is the upper left
/// one.
/// @param pixel   width of a pixel [um], > 0
/// @param centre  where the picture's centre lies [um]
/// @throws InputOutputError if the file cannot be read
/// @throws std::invalid_argument if it is no such picture, or has more than 16 million pixels
Samples samples_from_picture(const std::filesystem::path& file, double pixel, const Vec2& centre);

} // namespace matrigrate::fields
