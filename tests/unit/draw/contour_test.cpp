#include "draw/contour.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace matrigrate::draw {
namespace {

/// 1 - r/10 in a square of 30 um, from a function of the place.
template <typename Value>
Lattice lattice(Value value, double step = 0.5) {
  Lattice l{.low = Vec2(-15.0, -15.0), .step = step};
  l.nx = l.ny = static_cast<std::size_t>(30.0 / step) + 1;
  for (std::size_t j = 0; j < l.ny; ++j)
    for (std::size_t i = 0; i < l.nx; ++i) l.value.push_back(value(l.place(i, j)));
  return l;
}

TEST(Contours, GoAroundADisc) {
  const auto curves = contours(lattice([](const Vec2& x) { return 10.0 - x.norm(); }), 3.0);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_NEAR(enclosed(curves[0]), std::numbers::pi * 49.0, 0.5);
  for (const Vec2& x : curves[0]) EXPECT_NEAR(x.norm(), 7.0, 0.02);
}

TEST(Contours, HaveHolesWithANegativeArea) {
  const auto curves = contours(lattice([](const Vec2& x) { return -std::abs(x.norm() - 8.0); }), -2.0);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_NEAR(enclosed(curves[0]) + enclosed(curves[1]), std::numbers::pi * (100.0 - 36.0), 1.0);
  EXPECT_LT(std::min(enclosed(curves[0]), enclosed(curves[1])), 0.0);
}

TEST(Contours, AreClosedAlongTheBorder) {
  const auto curves = contours(lattice([](const Vec2& x) { return x.x(); }), 0.0);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_NEAR(enclosed(curves[0]), 15.0 * 30.0, 1e-9);
}

TEST(Contours, OfSquaresThatTouchAtACornerAreApart) {
  Lattice l{.nx = 3, .ny = 3};
  l.value = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto curves = contours(l, 0.5);
  ASSERT_EQ(curves.size(), 3U);
  for (const Curve& curve : curves) EXPECT_GT(enclosed(curve), 0.0);
}

TEST(Contours, OfNothingAreNone) {
  EXPECT_TRUE(contours(lattice([](const Vec2&) { return 0.0; }), 0.5).empty());
  EXPECT_THROW(contours({.nx = 3, .ny = 3}, 0.5), std::invalid_argument);
  EXPECT_THROW(contours({}, 0.5), std::invalid_argument);
}

} // namespace
} // namespace matrigrate::draw
