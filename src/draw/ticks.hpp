#pragma once

#include <string>
#include <vector>

/// Round numbers for axes, colour bars and scale bars. Test: tests/unit/draw/ticks_test.cpp
namespace matrigrate::draw {

struct Tick {
  double value = 0.0;
  std::string label; ///< empty for a grid line without a number
};

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`, which is positive.
double round_step(double least);

/// Multiples of a round step in [low, high]: at most `most` + 1 of them, all labelled to the same number of digits.
/// @param low, high  finite, low < high
std::vector<Tick> linear_ticks(double low, double high, int most);

/// Ticks of a logarithmic axis: decades, labelled at most `most` + 1 times, with grid lines between them where there is
/// room; below two decades also 2 and 5 times the decades; below that round steps.
/// @param low, high  finite, 0 < low < high
std::vector<Tick> log_ticks(double low, double high, int most);

} // namespace matrigrate::draw
