#pragma once

#include <string>
#include <vector>

/// Round numbers for colour bars and scale bars. Test: tests/unit/draw/draw_test.cpp
namespace matrigrate::draw {

struct Tick {
  double value = 0.0;
  std::string label;
};

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`, which is positive.
double round_step(double least);

/// Multiples of a round step in [low, high]: at most `most` + 1 of them, all labelled to the same number of digits.
/// @param low, high  finite, low < high
std::vector<Tick> linear_ticks(double low, double high, int most);

} // namespace matrigrate::draw
