#include "ecm/loop/fluid.hpp"

#include "ecm/law/material.hpp"
#include "sph/neighbours.hpp"
#include "unit/ecm/body.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

/// Everything scaled about the origin.
EcmState squeezed(double f, double scale) {
  EcmState ecm = rectangle(EcmParameters{}, 40.0, 40.0, 0.0);
  std::fill(ecm.f.begin(), ecm.f.end(), f);
  for (Vec2& x : ecm.x) x *= scale;
  return ecm;
}

double middle_pressure(const EcmState& ecm) {
  const EcmParameters p;
  return fluid_pressure(ecm, p, neighbours_within(ecm.x, 5.2, 0.0), Kernel(2.6), lattice_density(p), 10 * 20 + 10);
}

} // namespace

TEST(FluidPressure, IsNoneAtTheDensityOfTheLatticeAndUnderTension) {
  EXPECT_NEAR(middle_pressure(squeezed(0.0, 1.0)), 0.0, 1e-12);
  EXPECT_EQ(middle_pressure(squeezed(0.0, 1.05)), 0.0);
}

TEST(FluidPressure, FollowsTheEquationOfState) {
  const double K = moduli(EcmParameters{}).K;
  const double scale = 0.99;
  const double rise = 1.0 / (scale * scale) - 1.0;
  EXPECT_NEAR(middle_pressure(squeezed(0.0, scale)), K * rise, 0.05 * K * rise); // summed density: a few per cent
  EXPECT_NEAR(middle_pressure(squeezed(0.5, scale)), 0.5 * middle_pressure(squeezed(0.0, scale)), 1e-12);
  EXPECT_EQ(middle_pressure(squeezed(1.0, scale)), 0.0);
}

TEST(FluidForces, PushApartAndKeepMomentum) {
  const EcmParameters p;
  const EcmState ecm = squeezed(0.0, 0.95);
  const Adjacency pairs = neighbours_within(ecm.x, 5.2, 0.0);
  std::vector<double> pressure;
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  add_fluid_forces(ecm, p, pairs, pressure, force);
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, outwards = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    sum += force[i];
    torque += cross(ecm.x[i], force[i]);
    outwards += ecm.x[i].dot(force[i]);
  }
  EXPECT_NEAR(sum.norm(), 0.0, 1e-14);
  EXPECT_NEAR(torque, 0.0, 1e-13);
  EXPECT_GT(outwards, 0.1);
}

TEST(FluidForces, PushAWallOfSolidWithHalfTheirPressure) { // the solid has no pressure of its own in these sums
  const EcmParameters p;
  EcmState ecm = strip(p, 24.0, 60.0);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.f[i] = ecm.X[i].y() < 0.0 ? 0.0 : 1.0;
    ecm.x[i].y() *= 0.97;
  }
  const Adjacency pairs = neighbours_within(ecm.x, 5.2, ecm.period_x);
  std::vector<double> pressure;
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  add_fluid_forces(ecm, p, pairs, pressure, force);
  double on_wall = 0.0;
  double deep = 0.0; // pressure of the fluid away from the wall
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] > 0.0) on_wall += force[i].y();
    if (std::abs(ecm.X[i].y() + 15.0) < 1.1) deep = pressure[i];
  }
  ASSERT_GT(deep, 0.0);
  EXPECT_NEAR(on_wall / (ecm.period_x * p.thickness * deep), 0.5, 0.03);
}
