#include "protrusion/polarization.hpp"

#include "scene.hpp"

#include <gtest/gtest.h>

#include <numbers>

using namespace matrigrate;

namespace {
constexpr double pi = std::numbers::pi;
}

TEST(AdhesionDirection, IsTheMeanOfTheUnitVectorsToMatureAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 centre(1.0, -1.0);
  EXPECT_FALSE(adhesion_direction(s.cell, centre));
  add_protrusion(s, 0, Contracting{centre + Vec2(40.0, 0.0), 0.5});
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.0);
  add_protrusion(s, 60, Contracting{centre + Vec2(0.0, 3.0), 0.5}); // the distance does not count
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.25 * pi);
  add_protrusion(s, 120, Maturing{Vec2(-1.0, 0.0), centre + Vec2(-30.0, 0.0), 0}); // immature ones do not
  EXPECT_DOUBLE_EQ(*adhesion_direction(s.cell, centre), 0.25 * pi);
}

TEST(AdhesionDirection, IsNoneBetweenOppositeAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 0, Contracting{Vec2(20.0, 0.0), 0.5});
  add_protrusion(s, 117, Contracting{Vec2(-35.0, 0.0), 0.5});
  EXPECT_FALSE(adhesion_direction(s.cell, Vec2::Zero()));
}

TEST(Turned, ApproachesTheTargetExponentiallyAtRPol) {
  const PolarizationParameters p; // 1.1e-3 /s
  double angle = 0.2;
  for (int k = 0; k < 2500; ++k) angle = turned(angle, 1.2, 0.4, p); // 1000 s
  EXPECT_NEAR(1.2 - angle, std::exp(-1.1), 1e-9);
  EXPECT_NEAR(turned(0.2, 1.2, 1000.0, p), angle, 1e-9); // whatever the step
}

TEST(Turned, TakesTheShorterWayRound) {
  const PolarizationParameters p;
  EXPECT_GT(turned(3.0, -3.0, 0.4, p), 3.0);
  EXPECT_LT(turned(-3.0, 3.0, 0.4, p), -3.0);
  EXPECT_LE(std::abs(turned(3.1, -2.0, 1000.0, p)), pi);
}

TEST(Polarize, WaitsForTheFirstProtrusionAndForAdhesions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 0, Contracting{Vec2(0.0, 20.0), 0.5});
  polarize(s.cell, p.polarization, Vec2::Zero(), 0.4);
  EXPECT_FALSE(s.cell.polarization);
  s.cell.polarization = 0.0;
  polarize(s.cell, p.polarization, Vec2::Zero(), 0.4);
  EXPECT_NEAR(*s.cell.polarization, -std::expm1(-1.1e-3 * 0.4) * 0.5 * pi, 1e-12);
  s.cell.protrusions.clear();
  const double kept = *s.cell.polarization;
  polarize(s.cell, p.polarization, Vec2::Zero(), 0.4);
  EXPECT_EQ(*s.cell.polarization, kept);
}
