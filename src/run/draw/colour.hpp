#pragma once

#include <string>

/// Colours that people with any kind of colour vision can tell apart. Test: tests/unit/draw/colour_test.cpp
namespace matrigrate::draw {

enum class ColourMap {
  sequential, ///< viridis: dark blue to yellow, lightness rises evenly
  diverging   ///< blue, almost white, orange: for signed values
};

/// @param fraction  place on the map, clamped to [0, 1]
/// @return          "#rrggbb"
std::string colour(ColourMap map, double fraction);

} // namespace matrigrate::draw
