#pragma once

#include "draw/ticks.hpp"

#include <cmath>
#include <span>
#include <vector>

/// Where a number lies on a drawn axis. Test: tests/unit/draw/particle_picture_test.cpp
namespace matrigrate::draw {

/// True if a value has a place on an axis: finite, not so large that differences overflow.
inline bool drawable(double value) { return std::abs(value) < 1e150; }

struct Axis {
  double low = 0.0, high = 1.0;  ///< values at its ends, low < high
  double begin = 0.0, end = 1.0; ///< pixels at low and high
  std::vector<Tick> ticks;

  /// Pixel of a drawable value.
  double at(double value) const { return begin + (value - low) / (high - low) * (end - begin); }
};

/// An axis from the smallest to the largest value; ticks and pixels are set by the caller.
/// @param values  all drawable; [0, 1] where there are none
Axis fitted_axis(std::span<const double> values);

/// Width of the widest tick label [pixel].
double label_width(const Axis& axis);

} // namespace matrigrate::draw
