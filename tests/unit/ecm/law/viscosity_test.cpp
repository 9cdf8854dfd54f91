#include "ecm/law/viscosity.hpp"

#include "base/vector.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

TEST(PairDrag, IsThatOfEquation2) {
  const double h = 2.6;
  const Kernel kernel(h);
  const Vec2 x_ij(2.0, 1.0);
  const double r = x_ij.norm();
  const Vec2 grad_W = kernel.W_slope(r) * x_ij;
  EXPECT_DOUBLE_EQ(pair_drag(r * r, kernel.W_slope(r), 4.0, 1.5, 0.7, h),
                   0.7 * 4.0 * 4.0 * (1.5 + 1.5) * (-x_ij.dot(grad_W)) / (r * r + 0.01 * h * h));
  EXPECT_EQ(pair_drag(36.0, kernel.W_slope(6.0), 4.0, 1.0, 1.0, h), 0.0);
}

TEST(PairDrag, OfEqualParticlesIsTheSame) {
  const EcmParameters p;
  const Kernel kernel(p.smoothing_length);
  const PairDrag<double> in_double(p, kernel, 4.0);
  const PairDrag<float> in_float(p, kernel, 4.0);
  for (double r = 0.1; r < 6.0; r += 0.1) {
    const double G = pair_drag(r * r, kernel.W_slope(r), 4.0, p.viscosity, p.thickness, p.smoothing_length);
    EXPECT_NEAR(in_double(r, r * r), G, 1e-13 * in_double.G_0) << r;
    EXPECT_NEAR(static_cast<double>(in_float(static_cast<float>(r), static_cast<float>(r * r))), G,
                1e-6 * in_double.G_0)
        << r;
  }
}
