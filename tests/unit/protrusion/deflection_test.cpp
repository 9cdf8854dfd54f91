#include "protrusion/deflection.hpp"

#include "cell/geometry.hpp"
#include "scene.hpp"
#include "sph/kernel.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

const Vec2 tip(20.0, 0.0);
const Vec2 ahead(1.0, 0.0);
bool nowhere(const Vec2&) { return false; }

/// Intact matrix, but for where `degraded` says.
EcmState matrix(const Parameters& p, const std::function<bool(const Vec2&)>& degraded) {
  EcmState ecm = disc(p);
  for (std::size_t k = 0; k < ecm.size(); ++k) ecm.f[k] = degraded(ecm.x[k]) ? 0.0 : 1.0;
  return ecm;
}

} // namespace

TEST(Deflection, IsNoneInIntactOrSymmetricallyDegradedMatrix) {
  const Parameters p = small_matrix();
  EXPECT_EQ(deflection_speed(matrix(p, nowhere), p, tip, ahead, ahead, nowhere), 0.0);
  const EcmState strip = matrix(p, [](const Vec2& x) { return std::abs(x.y()) < 3.5; });
  EXPECT_NEAR(deflection_speed(strip, p, tip, ahead, ahead, nowhere), 0.0, 1e-12);
  const EcmState all = matrix(p, [](const Vec2&) { return true; });
  EXPECT_NEAR(deflection_speed(all, p, tip, ahead, ahead, nowhere), 0.0, 1e-12);
}

TEST(Deflection, TurnsTowardsDegradedMatrixAndMirrors) {
  const Parameters p = small_matrix();
  const double left =
      deflection_speed(matrix(p, [](const Vec2& x) { return x.y() > 0.5; }), p, tip, ahead, ahead, nowhere);
  const double right =
      deflection_speed(matrix(p, [](const Vec2& x) { return x.y() < -0.5; }), p, tip, ahead, ahead, nowhere);
  EXPECT_GT(left, 0.0);
  EXPECT_DOUBLE_EQ(left, -right);
  EXPECT_LT(left, p.protrusion.deflection_rate * std::sin(p.protrusion.deflection_cone)); // no faster than all there
}

TEST(Deflection, OfASingleFluidParticleIsItsWeightTimesTheSine) {
  Parameters p = small_matrix();
  const Vec2 there(24.0, 2.0);
  const EcmState ecm = matrix(p, [&](const Vec2& x) { return (x - there).norm() < 0.1; });
  const Kernel kernel(p.ecm.smoothing_length);
  double weights = 0.0;
  for (const Vec2& x : ecm.x) {
    const Vec2 r = x - tip;
    if (r.norm() > 2.4 && r.norm() < 5.2 && r.x() >= 0.5 * r.norm() - 1e-12) weights += kernel.W(r.norm());
  }
  const Vec2 r = there - tip;
  const double expected = 0.1 * kernel.W(r.norm()) * (r.y() / r.norm()) / weights;
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(deflection_speed(ecm, p, tip, ahead, ahead, nowhere), expected, 1e-9);
}

TEST(Deflection, LooksNeitherAtTheTunnelBehindNorAtItsOwnWork) {
  const Parameters p = small_matrix();
  const EcmState behind = matrix(p, [](const Vec2& x) { return x.x() < 20.5 && x.y() > -0.5; });
  EXPECT_EQ(deflection_speed(behind, p, tip, ahead, ahead, nowhere), 0.0);
  const EcmState near = matrix(p, [](const Vec2& x) { return (x - tip).norm() < 2.4 && x.y() > 0.0; });
  EXPECT_EQ(deflection_speed(near, p, tip, ahead, ahead, nowhere), 0.0);
}

TEST(Deflection, TurnsNoFurtherThanTheConeAheadOfTheTip) { // and not on and on into a gap beside the cell
  const Parameters p = small_matrix();
  const EcmState ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  Vec2 d = ahead;
  for (int k = 0; k < 2000; ++k) d = Eigen::Rotation2Dd(0.4 * deflection_speed(ecm, p, tip, d, ahead, nowhere)) * d;
  EXPECT_LT(std::acos(d.dot(ahead)), p.protrusion.deflection_cone);
  EXPECT_GT(d.y(), 0.3);
}

TEST(Deflection, DoesNotTurnIntoTheCellItself) {
  const Parameters p = small_matrix();
  const EcmState ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  const double speed = deflection_speed(ecm, p, tip, ahead, ahead, [](const Vec2& x) { return x.y() > 0.5; });
  EXPECT_EQ(speed, 0.0);
}

TEST(Deflect, TurnsTheDirectionOfGrowingProtrusionsAndKeepsItAUnitVector) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  s.ecm = matrix(p, [](const Vec2& x) { return x.y() > 0.5; });
  add_protrusion(s, 0, Growing{ahead});
  add_protrusion(s, 117, Maturing{-ahead, Vec2(-20.0, 0.0), 0});
  const std::vector<Vec2> n = normals(s.cell.cortex);
  for (int k = 0; k < 20; ++k) deflect(s.cell, s.ecm, p, 0.4, n, nowhere);
  const Vec2 d = std::get<Growing>(s.cell.protrusions[0].phase).direction;
  EXPECT_NEAR(d.norm(), 1.0, 1e-12);
  EXPECT_GT(d.y(), 0.05);
  EXPECT_EQ(std::get<Maturing>(s.cell.protrusions[1].phase).direction, Vec2(-ahead));
}
