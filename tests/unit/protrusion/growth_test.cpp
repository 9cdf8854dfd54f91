#include "protrusion/growth.hpp"

#include "cell/geometry.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace matrigrate;

TEST(PushingParticles, AreTheCentreAndThreeToEachSide) {
  const Parameters p = small_matrix();
  const Scene s = cell_in_matrix(p);
  const std::vector<std::size_t> pushing = pushing_particles(s.cell.cortex, 1, p.protrusion);
  EXPECT_EQ((std::set<std::size_t>(pushing.begin(), pushing.end())), (std::set<std::size_t>{233, 234, 0, 1, 2, 3, 4}));
}

TEST(GrowthForce, IsAShareOfFProtAlongItsDirectionAndFadesAsTheNormalTurns) {
  const ProtrusionParameters p;
  const Vec2 d = Vec2(3.0, 4.0) / 5.0;
  EXPECT_LT((growth_force(d, d, p) - 0.32 / 7.0 * d).norm(), 1e-15);
  const Vec2 turned = Eigen::Rotation2Dd(1.0471975511965976) * d; // 60 degrees
  EXPECT_LT((growth_force(d, turned, p) - 0.16 / 7.0 * d).norm(), 1e-15);
  EXPECT_EQ(growth_force(d, perpendicular(d), p).norm(), 0.0);
  EXPECT_EQ(growth_force(d, -d, p).norm(), 0.0);
}

TEST(AreaFactor, IsTheInverseAreaWhereANumberIsEnforced) {
  ProtrusionParameters p;
  EXPECT_EQ(area_factor(1.7, p), 1.0); // Eq. (10) is for a kept number alone
  p.number = 2;
  EXPECT_EQ(area_factor(0.9, p), 1.0);
  EXPECT_EQ(area_factor(1.0, p), 1.0);
  EXPECT_DOUBLE_EQ(area_factor(1.46, p), 1.0 / 1.46);
  EXPECT_DOUBLE_EQ(area_factor(2.0, p), 0.5);
  EXPECT_DOUBLE_EQ(area_factor(2.5, p), 0.4);
}

TEST(Growth, PushesOnlyTheTipsOfGrowingProtrusions) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 30, Growing{outward(s, 30)});
  add_protrusion(s, 120, Contracting{2.0 * s.cell.cortex.x[120], 0.5});
  std::vector<Vec2> force(s.nodes(), Vec2::Zero());
  add_growth(s.cell, p.protrusion, 1.0, normals(s.cell.cortex), s.first(), force);
  const Vec2 sum = net_force(force);
  EXPECT_GT(sum.dot(outward(s, 30)), 0.99 * 0.32); // the tip is nearly flat
  EXPECT_LE(sum.norm(), 0.32);
  EXPECT_LT(std::abs(cross(sum, outward(s, 30))), 1e-12);
  for (std::size_t i = 0; i < force.size(); ++i) {
    const bool at_tip = i >= s.node(27) && i <= s.node(33);
    EXPECT_EQ(force[i].norm() > 0.0, at_tip) << i;
  }
}

TEST(Spreading, EvensOutEachFlankAlongItsContourAndKeepsTipAndBase) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Growing{outward(s, 100)});
  for (std::size_t i = 95; i <= 105; ++i) s.cell.cortex.x[i] *= 1.6; // a spike: all stretch in two segments
  const CortexState before = s.cell.cortex;
  for (int k = 0; k < 400; ++k) spread_evenly(s.cell, p.protrusion, 0.4);
  for (const std::size_t kept : {80, 100, 120}) EXPECT_EQ(s.cell.cortex.x[kept], before.x[kept]);
  for (std::size_t i = 0; i < 80; ++i) EXPECT_EQ(s.cell.cortex.x[i], before.x[i]);
  EXPECT_EQ(s.cell.cortex.l0, before.l0);
  double longest = 0.0, shortest = 1e9;
  for (std::size_t i = 80; i < 100; ++i) {
    const double l = (s.cell.cortex.x[i + 1] - s.cell.cortex.x[i]).norm();
    longest = std::max(longest, l);
    shortest = std::min(shortest, l);
  }
  EXPECT_LT(longest, 1.02 * shortest);
  EXPECT_NEAR(area(s.cell.cortex), area(before), 0.03 * area(before));
}

TEST(Spreading, GoesAsFarInOneLongStepAsInManyShortOnes) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Growing{outward(s, 100)});
  for (const int side : {-1, 1}) // straight flanks, spaced more and more widely
    for (int k = 0; k <= 20; ++k) {
      const double share = k * (k + 1) / 420.0;
      const Vec2 tip = s.cell.cortex.x[100], base = s.cell.cortex.x[s.cell.cortex.along(100, 20 * side)];
      if (k > 0 && k < 20) s.cell.cortex.x[s.cell.cortex.along(100, k * side)] = (1.0 - share) * tip + share * base;
    }
  Scene once = s;
  spread_evenly(once.cell, p.protrusion, 2.4);
  for (int k = 0; k < 6; ++k) spread_evenly(s.cell, p.protrusion, 0.4);
  for (std::size_t i = 0; i < s.cell.cortex.size(); ++i)
    EXPECT_LT((once.cell.cortex.x[i] - s.cell.cortex.x[i]).norm(), 1e-9) << i;
}

TEST(Spreading, LeavesOtherPhasesAlone) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  s.cell.cortex = wavy_cortex(p.cell);
  add_protrusion(s, 100, Finishing{0.5});
  const CortexState before = s.cell.cortex;
  spread_evenly(s.cell, p.protrusion, 0.4);
  EXPECT_EQ(s.cell.cortex.x, before.x);
}

TEST(BaseTie, PullsTheEndsOfAWidenedBaseTogetherAndNothingElse) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const double width = base_width(s.cell.cortex, 100, p.protrusion);
  EXPECT_NEAR(width, (s.cell.cortex.x[120] - s.cell.cortex.x[80]).norm(), 1e-15);
  add_protrusion(s, 100, Growing{outward(s, 100), width});
  const auto tied = [&] {
    return assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
      add_base_ties(s.cell, p.protrusion, p.cell.spring_stiffness, 0.4, s.first(), force, A);
    });
  };
  const Vec2 along = (s.cell.cortex.x[120] - s.cell.cortex.x[80]) / width;
  s.cell.cortex.x[120] += 2.0 * along;
  const Assembled a = tied();
  const double T = 2.8 / 40.0 * 2.0; // k_s over the 40 segments
  EXPECT_LT((a.force[s.node(80)] - T * along).norm(), 1e-12);
  EXPECT_LT((a.force[s.node(120)] + T * along).norm(), 1e-12);
  EXPECT_LT(net_force(a.force).norm(), 1e-15);
  EXPECT_EQ(a.A.directed.size(), 2U);
  EXPECT_DOUBLE_EQ(a.A.directed.c[0], 0.4 * 2.8 / 40.0);
  EXPECT_NEAR(a.A.directed.c[1], 0.4 * T / (width + 2.0), 1e-12) << "across";
  s.cell.cortex.x[120] -= 3.0 * along;
  EXPECT_EQ(largest(tied().force), 0.0) << "tension only";
}

TEST(ProtrusionLength, RunsFromTheMiddleOfTheBaseToTheCentre) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 base = 0.5 * (s.cell.cortex.x[80] + s.cell.cortex.x[120]);
  s.cell.cortex.x[100] = base + Vec2(-12.0, 16.0);
  EXPECT_NEAR(protrusion_length(s.cell.cortex, 100, p.protrusion), 20.0, 1e-12);
}

TEST(RelaxedRestLengths, AreTheLengthsOfTheProtrusionAlone) {
  const Parameters p = small_matrix();
  CortexState c = wavy_cortex(p.cell);
  const CortexState before = c;
  relax_rest_lengths(c, 10, p.protrusion);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const bool inside = i < 30 || i >= 225; // 10 - 20 wraps to 225
    EXPECT_DOUBLE_EQ(c.l0[i], inside ? (c.x[c.next(i)] - c.x[i]).norm() : before.l0[i]) << i;
  }
}
