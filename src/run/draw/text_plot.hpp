#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Curves as text, for terminals. Test: tests/unit/draw/draw_test.cpp
namespace matrigrate::draw {

/// Two curves over the same abscissas.
struct TextPlot {
  std::string_view x_name;
  std::string_view x_unit; ///< empty of ratios
  double x_low = 0.0;
  double x_high = 0.0;
  std::vector<double> points;     ///< drawn as *, over the others; values that are not finite are left out
  std::vector<double> comparison; ///< drawn as .
  int width = 60;
  int height = 9;
};

/// Lines with the curves between 0 and their largest value.
std::string to_text(const TextPlot& plot);

} // namespace matrigrate::draw
