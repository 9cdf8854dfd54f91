#include "cell/repulsion.hpp"

#include "ring.hpp"

using namespace matrigrate;

namespace {

CortexForce repulsion_force(const CellParameters& p) {
  return [p](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_repulsion(c, p, time_step, first, force, A);
  };
}

/// A slit cell; the particles of one long side face the segments of the other.
CortexState slit(double width = 0.13) {
  CortexState c = box(6.0, width, 0.5);
  for (Vec2& x : c.x)
    if (x.y() > 0.0) x += Vec2(0.17, 0.01 * std::sin(3.0 * x.x()));
  return c;
}

} // namespace

TEST(Repulsion, IsHertzianWithinItsReach) {
  const CellParameters p;
  EXPECT_EQ(repulsion(0.2, p), 0.0);
  EXPECT_EQ(repulsion(0.3, p), 0.0);
  EXPECT_NEAR(repulsion(0.19, p), 1.4 * 1e-3, 1e-12);
  EXPECT_NEAR(repulsion(0.1, p), 1.4 * std::pow(0.1, 1.5), 1e-15);
}

TEST(Repulsion, HasNoBoundWhereTwoSidesTouch) {
  const CellParameters p;
  EXPECT_NEAR(repulsion(0.05, p), 1.4 * (std::pow(0.15, 1.5) + std::pow(0.1, 1.5)), 1e-15);
  EXPECT_NEAR(repulsion(0.1 - 1e-9, p), repulsion(0.1 + 1e-9, p), 1e-8);
  EXPECT_GT(repulsion(1e-3, p), 4.0) << "more than a whole cell pulls";
}

TEST(Repulsion, LeavesARingThatDoesNotTouchItselfAlone) {
  const CellParameters p;
  for (const CortexState& c : {round_cortex(p), wavy_cortex(p), box(6.0, 0.21, 0.5)}) {
    const Assembled a = assemble(repulsion_force(p), c);
    EXPECT_EQ(largest(a.force), 0.0);
    EXPECT_EQ(a.A.directed.size(), 0U);
    EXPECT_EQ(repulsion_energy(c, p), 0.0);
  }
}

TEST(Repulsion, DoesNotSeeTheNextTwoParticles) {
  const CellParameters p;
  CortexState c = round_cortex(p);
  for (Vec2& x : c.x) x *= 0.08 / c.l0[0]; // 0.16 um to the second particle, 0.24 um to the third
  EXPECT_EQ(largest(assemble(repulsion_force(p), c).force), 0.0);
  for (Vec2& x : c.x) x *= 0.06 / 0.08; // 0.18 um to the third
  EXPECT_GT(largest(assemble(repulsion_force(p), c).force), 0.0);
}

TEST(Repulsion, PushesTheSidesOfASlitApart) {
  const CellParameters p;
  const CortexState c = slit();
  const std::vector<Vec2> force = assemble(repulsion_force(p), c).force;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (std::abs(c.x[i].x()) < 1.5) {
      EXPECT_GT(force[i].y() * c.x[i].y(), 1e-4) << "particle " << i;
    }
}

TEST(Repulsion, ObeysTheLawsOfInternalForces) { expect_internal(repulsion_force(CellParameters{}), slit()); }

TEST(Repulsion, IsMinusTheGradientOfItsEnergy) {
  const CellParameters p;
  for (const double width : {0.13, 0.07}) {
    CortexState c = slit(width);
    EXPECT_GT(repulsion_energy(c, p), 1e-3);
    expect_minus_gradient(assemble(repulsion_force(p), c).force, c.x, [&] { return repulsion_energy(c, p); });
  }
}

TEST(Repulsion, IsImplicitAlongTheDistance) { // the sides approach: the normals do not turn
  const CellParameters p;
  for (const double width : {0.13, 0.07}) {
    const CortexState c = box(6.0, width, 0.5);
    std::vector<Vec2> v;
    for (const Vec2& x : c.x) v.emplace_back(0.0, x.y() > 0.0 ? -1.0 : 1.0);
    const std::vector<Vec2> drag = drag_force(assemble(repulsion_force(p), c).A, v);
    expect_same(drag, implicit_drag(repulsion_force(p), c, v, time_step), 1e-6);
  }
}
