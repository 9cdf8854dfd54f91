#pragma once

#include "draw/axis.hpp"
#include "draw/colour.hpp"

#include <string>

/// Values as colours, and the bar that explains them. Test: tests/unit/draw/particle_picture_test.cpp
namespace matrigrate::draw {

inline constexpr int colour_levels = 33;         ///< steps of a map; odd, so that a diverging one has a neutral step
inline constexpr double colour_bar_width = 18.0; ///< [pixel]

/// Step of the colour map for a value, or -1 if it is not finite.
int colour_level(double value, const Axis& axis);

/// @param level  not -1   @return "#rrggbb"
std::string level_colour(ColourMap map, int level);

/// The bar with its numbers at the right, from axis.begin up to axis.end.
/// @param left  [pixel]
std::string colour_bar(const Axis& axis, ColourMap map, double left);

} // namespace matrigrate::draw
