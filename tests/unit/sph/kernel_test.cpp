#include "sph/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace matrigrate;

TEST(Kernel, IntegratesToOneOverThePlane) {
  const Kernel kernel(2.6);
  const int n = 20000;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) {
    const double r = (k + 0.5) / n * kernel.support();
    sum += kernel.W(r) * 2.0 * std::numbers::pi * r * kernel.support() / n;
  }
  EXPECT_NEAR(sum, 1.0, 1e-8);
}

TEST(Kernel, SlopeIsTheDerivativeOverTheDistance) {
  const Kernel kernel(2.6);
  const double d = 1e-6;
  for (const double r : {0.3, 1.0, 2.0, 2.6, 4.0, 5.1})
    EXPECT_NEAR(kernel.W_slope(r), (kernel.W(r + d) - kernel.W(r - d)) / (2.0 * d) / r, 1e-9);
}

TEST(Kernel, SlopeShapeIsTheSlopeOverThatAtZero) {
  const Kernel kernel(2.6);
  for (double r = 0.0; r < 6.0; r += 0.1)
    EXPECT_NEAR(slope_shape(r, 1.0 / kernel.support()), kernel.W_slope(r) / kernel.W_slope(0.0), 1e-15) << r;
}

TEST(Kernel, VanishesSmoothlyAtTheEdgeOfItsSupport) {
  const Kernel kernel(1.3);
  EXPECT_EQ(kernel.W(kernel.support()), 0.0);
  EXPECT_EQ(kernel.W_slope(kernel.support()), 0.0);
  EXPECT_EQ(kernel.W(7.0), 0.0);
  EXPECT_GT(kernel.W(0.0), kernel.W(0.5));
  EXPECT_LT(kernel.W_slope(0.0), 0.0);
}
