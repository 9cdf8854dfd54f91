#include "draw/colour.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(Colour, SequentialMapGetsLighterEvenly) {
  constexpr int steps = 20;
  const double rise =
      (lightness(colour(ColourMap::sequential, 1.0)) - lightness(colour(ColourMap::sequential, 0.0))) / steps;
  EXPECT_GT(rise * steps, 60.0);
  for (int i = 0; i < steps; ++i) {
    const double a = lightness(colour(ColourMap::sequential, static_cast<double>(i) / steps));
    const double b = lightness(colour(ColourMap::sequential, static_cast<double>(i + 1) / steps));
    EXPECT_GT(b - a, 0.4 * rise) << i;
    EXPECT_LT(b - a, 1.6 * rise) << i;
  }
}

TEST(Colour, DivergingMapIsLightestInTheMiddleAndEvenOnBothSides) {
  const auto at = [](double f) { return lightness(colour(ColourMap::diverging, f)); };
  EXPECT_EQ(colour(ColourMap::diverging, 0.5), "#f0f0f0");
  for (int i = 0; i < 10; ++i) {
    EXPECT_LT(at(0.05 * i), at(0.05 * (i + 1)));
    EXPECT_LT(at(1.0 - 0.05 * i), at(1.0 - 0.05 * (i + 1)));
    EXPECT_NEAR(at(0.05 * i), at(1.0 - 0.05 * i), 8.0) << "one sign must not look larger than the other";
  }
}

TEST(Colour, ClampsToItsEnds) {
  EXPECT_EQ(colour(ColourMap::sequential, -3.0), "#440154");
  EXPECT_EQ(colour(ColourMap::sequential, 1.5), "#fde725");
}

} // namespace
} // namespace matrigrate::draw
