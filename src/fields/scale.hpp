#pragma once

#include <optional>
#include <string>

/// The width of a pixel that a TIFF states. Test: tests/unit/fields/scale_test.cpp
namespace matrigrate::fields {

/// What a TIFF says of its scale.
struct StatedScale {
  std::string description;                       ///< of its first page: OME-XML, or what ImageJ writes
  double x_resolution = 0.0, y_resolution = 0.0; ///< pixels in a unit; 0: not stated
  enum class Unit { none, inch, centimetre } unit = Unit::none;
};

/// From OME-XML (PhysicalSizeX), from ImageJ's description (unit=micron), or from pixels in a centimetre. Pixels in an
/// inch are those of printers, and state nothing [um].
/// @return nothing if the file does not state it
/// @throws std::invalid_argument if pixels are not square
std::optional<double> pixel_width(const StatedScale& scale);

} // namespace matrigrate::fields
