#pragma once

#include "draw/ticks.hpp"

#include <cmath>
#include <span>
#include <vector>

/// Where a number lies on a drawn axis. Test: tests/unit/draw/plot_test.cpp
namespace matrigrate::draw {

/// True if a value has a place on an axis: finite, not so large that differences overflow, positive on a logarithmic
/// one.
inline bool drawable(double value, bool log) { return std::abs(value) < 1e150 && (!log || value > 1e-150); }

struct Axis {
  double low = 0.0, high = 1.0; ///< values at its ends, low < high
  bool log = false;
  double begin = 0.0, end = 1.0; ///< pixels at low and high
  std::vector<Tick> ticks;

  /// Pixel of a drawable value.
  double at(double value) const {
    const double share = log ? std::log10(value / low) / std::log10(high / low) : (value - low) / (high - low);
    return begin + share * (end - begin);
  }
};

/// An axis with some room around the values and ticks at round numbers; its pixels are set by the caller.
/// @param values  all drawable; [0, 1] or [1, 10] where there are none
/// @param room    share of the extent that is left free on either side
/// @param most    about the largest number of labels
Axis fitted_axis(std::span<const double> values, bool log, double room, int most);

/// Width of the widest tick label [pixel].
double label_width(const Axis& axis);

} // namespace matrigrate::draw
