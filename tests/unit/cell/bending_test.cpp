#include "cell/bending.hpp"

#include "ring.hpp"

using namespace matrigrate;

namespace {

CortexForce bending(const CellParameters& p) {
  return [p](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_bending(c, p, time_step, first, force, A);
  };
}

} // namespace

TEST(TurningAngle, OfASquareAndOfAnyRing) {
  const CortexState square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(turning_angle(square, i), std::numbers::pi / 2.0, 1e-15);
  const CortexState c = wavy_cortex(CellParameters{});
  double sum = 0.0;
  double least = 1.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    sum += turning_angle(c, i);
    least = std::min(least, turning_angle(c, i));
  }
  EXPECT_NEAR(sum, 2.0 * std::numbers::pi, 1e-12);
  EXPECT_LT(least, 0.0); // to the right where the ring is concave
}

TEST(TurningAngle, GradientIsTheDerivative) {
  CortexState c = wavy_cortex(small_cell());
  for (const std::size_t i : {std::size_t{0}, std::size_t{17}, c.size() - 1}) {
    const std::array<Vec2, 3> g = turning_angle_gradient(c, i);
    std::vector<Vec2> minus_gradient(c.size(), Vec2::Zero());
    minus_gradient[c.previous(i)] = -g[0];
    minus_gradient[i] = -g[1];
    minus_gradient[c.next(i)] = -g[2];
    expect_minus_gradient(minus_gradient, c.x, [&] { return turning_angle(c, i); });
  }
}

TEST(Bending, IsAtRestOnARoundCellOfAnySize) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  for (const double scale : {1.0, 2.5}) {
    for (Vec2& x : c.x) x *= scale;
    EXPECT_LT(largest(assemble(bending(p), c).force), 1e-14);
    EXPECT_NEAR(bending_energy(c, p), 0.0, 1e-25);
  }
}

TEST(Bending, ObeysTheLawsOfInternalForces) {
  const CellParameters p = small_cell();
  expect_internal(bending(p), wavy_cortex(p));
}

TEST(Bending, IsMinusTheGradientOfItsEnergy) {
  const CellParameters p = small_cell();
  CortexState c = wavy_cortex(p);
  expect_minus_gradient(assemble(bending(p), c).force, c.x, [&] { return bending_energy(c, p); });
}

TEST(Bending, FlattensASpike) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  c.x[0] *= 1.05;
  const std::vector<Vec2> force = assemble(bending(p), c).force;
  EXPECT_LT(force[0].x(), 0.0);
  EXPECT_GT(force[1].x(), 0.0);
  EXPECT_GT(force[c.size() - 1].x(), 0.0);
}

TEST(Bending, IsFullyImplicitAtRest) { // where the Gauss-Newton part is the whole Hessian
  const CellParameters p = small_cell();
  const CortexState c = round_cortex(p);
  const std::vector<Vec2> v = stirred(c.size());
  expect_same(drag_force(assemble(bending(p), c).A, v), implicit_drag(bending(p), c, v, time_step), 1e-6);
}

TEST(Bending, ImplicitDragIsThatOfTheTurningAngles) { // time_step k_bend sum (d theta/time_step)^2, at any shape
  const CellParameters p = small_cell();
  const CortexState c = wavy_cortex(p);
  const std::vector<Vec2> v = stirred(c.size());
  CortexState after = c;
  CortexState before = c;
  for (std::size_t i = 0; i < c.size(); ++i) {
    after.x[i] += 1e-6 * v[i];
    before.x[i] -= 1e-6 * v[i];
  }
  double expected = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i)
    expected +=
        time_step * p.bending_stiffness * std::pow((turning_angle(after, i) - turning_angle(before, i)) / 2e-6, 2);
  EXPECT_NEAR(power(drag_force(assemble(bending(p), c).A, v), v), expected, 1e-7 * expected);
}
