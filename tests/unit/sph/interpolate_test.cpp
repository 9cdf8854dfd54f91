#include "sph/interpolate.hpp"

#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace matrigrate;

namespace {

EcmState gel() { return rectangle(EcmParameters{}, 40.0, 40.0, 0.0); }
const Kernel kernel(2.6);

} // namespace

TEST(PointWeights, SumToOneWithFullSupportInside) {
  const PointWeights w = solid_weights(gel(), kernel, Vec2(0.3, -0.7));
  EXPECT_NEAR(std::accumulate(w.weight.begin(), w.weight.end(), 0.0), 1.0, 1e-14);
  EXPECT_NEAR(w.support, 1.0, 0.02);
}

TEST(PointWeights, LeaveOutFluidAndFadeWithIt) {
  EcmState ecm = gel();
  const double intact = solid_weights(ecm, kernel, Vec2::Zero()).support;
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.f[i] = ecm.X[i].x() < 0.0 ? 0.0 : 0.5;
  const PointWeights w = solid_weights(ecm, kernel, Vec2::Zero());
  for (const std::uint32_t i : w.index) EXPECT_GT(ecm.X[i].x(), 0.0);
  EXPECT_NEAR(w.support, 0.25 * intact, 1e-12);
  std::fill(ecm.f.begin(), ecm.f.end(), 0.0);
  EXPECT_EQ(solid_weights(ecm, kernel, Vec2::Zero()).support, 0.0);
}

TEST(PointWeights, SpreadAndInterpolateAreAdjoint) {
  const EcmState ecm = gel();
  const PointWeights w = solid_weights(ecm, kernel, Vec2(1.1, 0.4));
  std::vector<Vec2> force(ecm.size(), Vec2::Zero()), v(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) v[i] = Vec2(0.1 * ecm.X[i].y() - 0.3, ecm.X[i].x());
  const Vec2 pull(0.4, -0.2);
  spread(w, pull, force);
  double power = 0.0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    power += force[i].dot(v[i]);
    sum += force[i];
  }
  EXPECT_NEAR(power, pull.dot(interpolate(w, v)), 1e-14);
  EXPECT_NEAR((sum - pull).norm(), 0.0, 1e-15);
}
