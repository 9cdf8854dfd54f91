#include "cell/spring.hpp"

#include "ring.hpp"

using namespace matrigrate;

namespace {

/// Stiffness that differs from segment to segment.
std::vector<double> uneven_stiffness(const CortexState& c) {
  std::vector<double> k;
  for (std::size_t i = 0; i < c.size(); ++i) k.push_back(1.0 + 0.5 * std::sin(static_cast<double>(i)));
  return k;
}

CortexForce springs(const CellParameters& p) {
  return [p](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_springs(c, p, uneven_stiffness(c), time_step, first, force, A);
  };
}

CellParameters without_dashpots() {
  CellParameters p = small_cell();
  p.dashpot = 0.0;
  return p;
}

} // namespace

TEST(Springs, PullWhenStretchedAndPushWhenShortened) {
  EXPECT_DOUBLE_EQ(spring_tension(2.8, 0.5, 0.4), 2.8 * 0.1);
  EXPECT_DOUBLE_EQ(spring_tension(2.8, 0.3, 0.4), -2.8 * 0.1);
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  for (Vec2& x : c.x) x *= 1.1;
  const std::vector<Vec2> force = assemble(springs(p), c).force;
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_LT(force[i].dot(c.x[i]), 0.0);
}

TEST(Springs, AreAtRestOnTheRoundCell) {
  const CellParameters p = small_cell();
  const CortexState c = round_cortex(p);
  EXPECT_LT(largest(assemble(springs(p), c).force), 1e-13);
  EXPECT_NEAR(spring_energy(c, uneven_stiffness(c)), 0.0, 1e-25);
  EXPECT_EQ(crowding_energy(c, p), 0.0);
}

TEST(Springs, ObeyTheLawsOfInternalForces) {
  const CellParameters p = small_cell();
  expect_internal(springs(p), wavy_cortex(p));
  expect_internal(springs(p), wavy_cortex(p, 0.5)); // crowded
}

TEST(Springs, AreMinusTheGradientOfTheirEnergyCrowdedOrNot) {
  const CellParameters p = small_cell();
  for (const double scale : {1.0, 0.5}) {
    CortexState c = wavy_cortex(p, scale);
    EXPECT_EQ(crowding_energy(c, p) > 1e-3, scale < 1.0);
    expect_minus_gradient(assemble(springs(p), c).force, c.x,
                          [&] { return spring_energy(c, uneven_stiffness(c)) + crowding_energy(c, p); });
  }
}

TEST(Springs, AreFullyImplicitWhereTheyPull) {
  const CellParameters p = without_dashpots();
  const CortexState c = wavy_cortex(p, 1.8); // all stretched
  const std::vector<Vec2> v = stirred(c.size());
  expect_same(drag_force(assemble(springs(p), c).A, v), implicit_drag(springs(p), c, v, time_step), 1e-7);
}

TEST(Springs, AreImplicitAlongTheSegmentWhereTheyPush) {
  const CellParameters p = without_dashpots();
  CortexState c = round_cortex(p);
  for (Vec2& x : c.x) x *= 0.4; // all shortened, and crowded
  const double l = 0.4 * c.l0[0];
  const double slope = (crowding_tension(l + 1e-6, p) - crowding_tension(l - 1e-6, p)) / 2e-6;
  double expected = 0.0; // growing at v = x, each segment lengthens by its length
  for (const double k : uneven_stiffness(c)) expected += time_step * (k + slope) * l * l;
  EXPECT_NEAR(power(drag_force(assemble(springs(p), c).A, c.x), c.x), expected, 1e-6 * expected);
}

TEST(Dashpots, ResistTheChangeOfLength) {
  const CellParameters p = small_cell();
  const CortexState c = wavy_cortex(p);
  const Assembled a = assemble(c.size(), [&](std::span<Vec2> force, DragSystem& A) {
    add_springs(c, p, uneven_stiffness(c), 0.0, 0, force, A);
  });
  const std::vector<Vec2> v = stirred(c.size());
  double expected = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 e = c.x[c.next(i)] - c.x[i];
    expected += p.dashpot * std::pow(e.dot(v[c.next(i)] - v[i]) / e.norm(), 2);
  }
  EXPECT_NEAR(power(drag_force(a.A, v), v), expected, 1e-12 * expected);
  std::vector<Vec2> turning;
  for (const Vec2& x : c.x) turning.push_back(perpendicular(x));
  EXPECT_LT(largest(drag_force(a.A, turning)), 1e-12);
}

TEST(Crowding, ResistsOnlyBelowItsLengthAndWithoutBoundAbove) {
  const CellParameters p = small_cell();
  const double l_c = p.crowding * initial_segment_length(p);
  EXPECT_EQ(crowding_tension(l_c, p), 0.0);
  EXPECT_EQ(crowding_tension(2.0 * l_c, p), 0.0);
  EXPECT_NEAR(crowding_tension(0.999 * l_c, p), 0.0, 0.0011 * p.spring_stiffness * l_c); // sets in gently
  EXPECT_NEAR(crowding_tension(0.5 * l_c, p), -p.spring_stiffness * l_c, 1e-15);
  for (double l = 0.002 * l_c; l < 0.99 * l_c; l += 0.01 * l_c)
    EXPECT_LT(crowding_tension(l, p), crowding_tension(l + 0.01 * l_c, p));
  EXPECT_LT(crowding_tension(0.002 * l_c, p), -100.0 * p.spring_stiffness * l_c); // more than any load
  EXPECT_TRUE(std::isfinite(crowding_tension(0.0, p)));
}

TEST(Tension, PullsBothEndsTogetherAndIsFullyImplicit) {
  const CortexState c = polygon({{0, 0}, {3, 4}, {-5, 6}});
  const CortexForce tension = [](const CortexState& ring, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_tension(ring, 0, 2.0, time_step, first, force, A);
  };
  const Assembled a = assemble(tension, c);
  EXPECT_LT((a.force[0] - Vec2(1.2, 1.6)).norm(), 1e-15);
  EXPECT_LT((a.force[1] + Vec2(1.2, 1.6)).norm(), 1e-15);
  EXPECT_EQ(a.force[2].norm(), 0.0);
  expect_internal(tension, c);
  const std::vector<Vec2> v = stirred(3);
  expect_same(drag_force(a.A, v), implicit_drag(tension, c, v, time_step), 1e-7);
}
