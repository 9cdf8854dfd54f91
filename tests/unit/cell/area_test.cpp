#include "cell/area.hpp"

#include "cell/geometry.hpp"
#include "ring.hpp"

using namespace matrigrate;

namespace {

CortexForce area_force(const CellParameters& p) {
  return [p](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_area(c, p, time_step, first, force, A);
  };
}

CortexState scaled(const CellParameters& p, double scale) {
  CortexState c = round_cortex(p);
  for (Vec2& x : c.x) x *= scale;
  return c;
}

} // namespace

TEST(Area, ActsOnlyWhileTheCellIsTooSmall) {
  const CellParameters p;
  for (const double scale : {1.0 + 1e-9, 1.01, 2.0}) {
    const CortexState c = scaled(p, scale);
    const Assembled a = assemble(area_force(p), c);
    EXPECT_EQ(largest(a.force), 0.0);
    EXPECT_EQ(a.A.directed.size(), 0U);
    EXPECT_EQ(area_energy(c, p), 0.0);
  }
  EXPECT_GT(largest(assemble(area_force(p), scaled(p, 0.999)).force), 0.0);
}

TEST(Area, PushesEachParticleOfTheRoundCellByThePapersForce) { // k_A (A_0 - A) along the normal
  const CellParameters p;
  const CortexState c = scaled(p, 0.999);
  const std::vector<Vec2> force = assemble(area_force(p), c).force;
  const double expected = p.area_stiffness * (initial_area(p) - area(c));
  EXPECT_NEAR(expected, 0.71e-3 * 0.001999 * 706.8, 1e-6);
  for (std::size_t i = 0; i < c.size(); ++i)
    EXPECT_LT((force[i] - expected * normal(c, i)).norm(), 0.0015 * expected); // the ring is 0.1 % shorter
}

TEST(Area, ObeysTheLawsOfInternalForces) {
  const CellParameters p = small_cell();
  expect_internal(area_force(p), wavy_cortex(p, 0.9));
}

TEST(Area, IsMinusTheGradientOfItsEnergy) {
  const CellParameters p = small_cell();
  CortexState c = wavy_cortex(p, 0.9);
  expect_minus_gradient(assemble(area_force(p), c).force, c.x, [&] { return area_energy(c, p); });
}

TEST(Area, IsImplicitInTheAreaThatTheNextStepFinds) { // the force grows as the missing area does
  const CellParameters p = small_cell();
  const CortexState c = wavy_cortex(p, 0.9);
  std::vector<Vec2> v = stirred(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) v[i] += 0.2 * c.x[i]; // it grows
  CortexState after = c;
  CortexState before = c;
  for (std::size_t i = 0; i < c.size(); ++i) {
    after.x[i] += 1e-6 * v[i];
    before.x[i] -= 1e-6 * v[i];
  }
  const double growth = (area(after) - area(before)) / 2e-6;
  const Assembled a = assemble(area_force(p), c);
  std::vector<Vec2> expected = a.force;
  for (Vec2& f : expected) f *= time_step * growth / (initial_area(p) - area(c));
  expect_same(drag_force(a.A, v), expected, 1e-8);
}
