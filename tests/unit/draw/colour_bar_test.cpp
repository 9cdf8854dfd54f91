#include "draw/colour_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace matrigrate::draw {
namespace {

/// Perceived lightness L* of CIELAB, 0 black to 100 white.
double lightness(const std::string& colour) {
  const auto linear = [&](std::size_t at) {
    const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double luminance = 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
  return luminance > 0.008856 ? 116.0 * std::cbrt(luminance) - 16.0 : 903.3 * luminance;
}

TEST(Colour, GetsLighterEvenly) {
  constexpr int steps = 20;
  const double rise = (lightness(colour(1.0)) - lightness(colour(0.0))) / steps;
  EXPECT_GT(rise * steps, 60.0);
  for (int i = 0; i < steps; ++i) {
    const double a = lightness(colour(static_cast<double>(i) / steps));
    const double b = lightness(colour(static_cast<double>(i + 1) / steps));
    EXPECT_GT(b - a, 0.4 * rise) << i;
    EXPECT_LT(b - a, 1.6 * rise) << i;
  }
}

TEST(Colour, ClampsToItsEnds) {
  EXPECT_EQ(colour(-3.0), "#440154");
  EXPECT_EQ(colour(1.5), "#fde725");
}

TEST(ColourScale, ReachesFromTheSmallestToTheLargestValue) {
  const ColourScale scale = fitted_scale(std::vector<double>{3.0, -1.0, 2.0});
  EXPECT_EQ(scale.low, -1.0);
  EXPECT_EQ(scale.high, 3.0);
  EXPECT_EQ(scale.level(-1.0), 0);
  EXPECT_EQ(scale.level(1.0), colour_levels / 2);
  EXPECT_EQ(scale.level(5.0), colour_levels - 1);
}

TEST(ColourScale, GivesOneValueANeighbourhood) {
  for (const double value : {0.0, 5.0, -1e-9, 1e140}) {
    const ColourScale scale = fitted_scale(std::vector<double>{value});
    EXPECT_LT(scale.low, value);
    EXPECT_GT(scale.high, value);
  }
}

} // namespace
} // namespace matrigrate::draw
