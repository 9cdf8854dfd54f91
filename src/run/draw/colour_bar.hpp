#pragma once

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace matrigrate::draw {

// Round numbers for colour bars and scale bars. Test: tests/unit/draw/draw_test.cpp

struct Tick {
  double value = 0.0;
  std::string label;
};

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`, which is positive.
double round_step(double least);

/// Multiples of a round step in [low, high]: at most `most` + 1 of them, all labelled to the same number of digits.
/// @param low, high  finite, low < high
std::vector<Tick> linear_ticks(double low, double high, int most);

// Values as colours, and the bar that explains them. Test: tests/unit/draw/draw_test.cpp

inline constexpr int colour_levels = 33;         ///< steps of the colours
inline constexpr double colour_bar_width = 18.0; ///< [pixel]

/// True if a value has a place on a scale: finite, not so large that differences overflow.
inline bool drawable(double value) { return std::abs(value) < 1e150; }

/// The values that the ends of the colours stand for, low < high.
struct ColourScale {
  double low = 0.0, high = 1.0;

  int level(double value) const; ///< step of the colours; -1 if the value is not finite
  std::vector<Tick> ticks() const;
  double label_width() const; ///< of the widest tick label [pixel]
};

/// From the smallest to the largest value; [0, 1] where there are none.
/// @param values  all drawable
ColourScale fitted_scale(std::span<const double> values);

/// Viridis, dark blue to yellow: its lightness rises evenly, for people with any kind of colour vision.
/// @param fraction  clamped to [0, 1]   @return "#rrggbb"
std::string colour(double fraction);

/// @param level  not -1   @return "#rrggbb"
std::string level_colour(int level);

/// The bar with its numbers at the right.
/// @param left, top, height  [pixel]
std::string colour_bar(const ColourScale& scale, double left, double top, double height);

} // namespace matrigrate::draw
