#pragma once

#include <string>
#include <string_view>

/// Colours that people with any kind of colour vision can tell apart. Test: tests/unit/draw/colour_test.cpp
namespace matrigrate::draw {

/// A colour of the Okabe-Ito palette, in an order that leaves the lightest for last; goes round after the last.
std::string_view palette(int index);

enum class ColourMap {
  sequential, ///< viridis: dark blue to yellow, lightness rises evenly
  diverging   ///< blue, almost white, orange: for signed values
};

/// @param fraction  place on the map, clamped to [0, 1]
/// @return          "#rrggbb"
std::string colour(ColourMap map, double fraction);

} // namespace matrigrate::draw
