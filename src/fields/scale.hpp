#pragma once

#include <cstddef>
#include <optional>
#include <string>

/// How large the pixels are that a TIFF states. Test: tests/unit/fields/scale_test.cpp
namespace matrigrate::fields {

/// Sides of a pixel [um].
struct PixelSize {
  double width = 0.0, height = 0.0;

  bool operator==(const PixelSize&) const = default;
};

/// What a TIFF says of the scale of a page.
struct StatedScale {
  std::string description;                       ///< of its first page: OME-XML, or what ImageJ writes
  double x_resolution = 0.0, y_resolution = 0.0; ///< of the page: pixels in a unit; 0: not stated
  enum class Unit { none, inch, centimetre } unit = Unit::none;
  std::size_t directory = 0;         ///< the page's number among all, from 0
  std::size_t columns = 0, rows = 0; ///< of the page [pixel]; 0: any
};

/// From the Image of OME-XML that the page belongs to (PhysicalSizeX), from ImageJ's description (unit=micron), or from
/// pixels in a centimetre. Pixels in an inch are those of printers, and state nothing.
/// @return nothing if the file does not state it
std::optional<PixelSize> pixel_size(const StatedScale& scale);

} // namespace matrigrate::fields
