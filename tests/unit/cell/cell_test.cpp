#include "cell/actomyosin.hpp"
#include "cell/area.hpp"
#include "cell/bending.hpp"
#include "cell/geometry.hpp"
#include "cell/repulsion.hpp"
#include "cell/spring.hpp"
#include "ring.hpp"

using namespace matrigrate;

namespace {

std::vector<double> uneven_maturation(const CortexState& c) {
  std::vector<double> f_mat;
  for (std::size_t i = 0; i < c.size(); ++i) f_mat.push_back(0.3 + 0.2 * std::sin(static_cast<double>(i)));
  return f_mat;
}

/// The laws of the paper.
const Laws& laws() {
  static const Laws all(Parameters{});
  return all;
}

double curvature_factor(double kappa) { return laws().curvature_factor({kappa}); }

/// Tension of a segment of the paper.
double tension(double f_mat, double kappa) { return F_am({f_mat, curvature_factor(kappa), kappa}, laws()); }

CortexForce actomyosin(const std::function<std::vector<double>(const CortexState&)>& f_mat) {
  return [f_mat](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_actomyosin(c, f_mat(c), {}, time_step, first, force, A, laws());
  };
}

} // namespace

TEST(CurvatureFactor, IsOneAtTheOptimumAndSymmetricAroundIt) {
  EXPECT_EQ(curvature_factor(-0.15), 1.0);
  for (double q = 0.0; q < 2.0; q += 0.05) {
    const double there = curvature_factor(-0.15 + q);
    EXPECT_NEAR(curvature_factor(-0.15 - q), there, 1e-14);
    EXPECT_LE(curvature_factor(-0.15 + q + 0.05), there);
    EXPECT_GE(there, 0.0);
  }
  EXPECT_LT(curvature_factor(3.0), 1e-9);
  EXPECT_LT(curvature_factor(-3.0), 1e-9);
}

TEST(CurvatureFactor, FallsToOneOverEAtOneWidth) { EXPECT_NEAR(curvature_factor(0.10), std::exp(-1.0), 1e-12); }

TEST(CurvatureFactor, OfTheRoundBodyIsSmallerThanOfAConcaveFlank) {
  EXPECT_NEAR(curvature_factor(1.0 / 15.0), std::exp(-std::pow((1.0 / 15.0 + 0.15) / 0.25, 2)), 1e-12); // 0.47
  EXPECT_NEAR(curvature_factor(-0.1), std::exp(-0.04), 1e-12);
}

TEST(Eq6, TakesTheLesserMaturationOfBothEnds) {
  const CortexState c = round_cortex(CellParameters{});
  std::vector<double> f_mat(c.size(), 1.0);
  f_mat[1] = 0.2;
  f_mat[2] = 0.7;
  const std::vector<double> kappa(c.size(), -0.15);
  const auto of = [&](std::size_t i) { return F_am(strand(c, i, f_mat, kappa, laws(), {}), laws()); };
  EXPECT_DOUBLE_EQ(of(5), 0.6);
  EXPECT_DOUBLE_EQ(of(0), 0.12);
  EXPECT_DOUBLE_EQ(of(1), 0.12);
  EXPECT_DOUBLE_EQ(of(2), 0.42);
  EXPECT_EQ(tension(0.0, -0.15), 0.0);
  EXPECT_DOUBLE_EQ(tension(0.2, 0.2), 0.12 * curvature_factor(0.2));
}

TEST(Actomyosin, ContractsTheRoundCell) {
  const CellParameters cell;
  const CortexState c = round_cortex(cell);
  const auto body = [](const CortexState& ring) { return std::vector<double>(ring.size(), 0.05); };
  const std::vector<Vec2> force = assemble(actomyosin(body), c).force;
  const double inwards = 2.0 * tension(0.05, 1.0 / 15.0) * std::sin(std::numbers::pi / 235.0);
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_LT((force[i] + inwards * c.x[i] / 15.0).norm(), 1e-13);
}

TEST(Actomyosin, LeavesProtrusionsThatGrowOrMatureAlone) {
  const CortexState c = round_cortex(small_cell());
  const auto with_gap = [](const CortexState& ring) {
    std::vector<double> f_mat(ring.size(), 0.5);
    for (std::size_t i = 10; i <= 20; ++i) f_mat[i] = 0.0;
    return f_mat;
  };
  const Assembled a = assemble(actomyosin(with_gap), c);
  for (std::size_t i = 10; i <= 20; ++i) EXPECT_EQ(a.force[i].norm(), 0.0);
  EXPECT_GT(a.force[9].dot(c.x[8] - c.x[9]), 0.0); // drawn away from it
  EXPECT_EQ(a.A.directed.size(), c.size() - 12);
}

TEST(Actomyosin, UsesTheMeanCurvatureOfBothEnds) {
  const CortexState c = wavy_cortex(small_cell());
  std::vector<double> f_mat(c.size(), 0.0);
  f_mat[5] = f_mat[6] = 0.8; // the tension of a single segment
  const std::vector<Vec2> force = assemble(actomyosin([&](const CortexState&) { return f_mat; }), c).force;
  const double kappa = 0.5 * (curvature(c, 5) + curvature(c, 6));
  EXPECT_GT(std::abs(curvature(c, 5) - kappa), 1e-3);
  EXPECT_LT((force[5] - tension(0.8, kappa) * (c.x[6] - c.x[5]).normalized()).norm(), 1e-15);
  EXPECT_LT((force[6] + force[5]).norm(), 1e-15);
}

TEST(Actomyosin, ObeysTheLawsOfInternalForces) {
  expect_internal(actomyosin(uneven_maturation), wavy_cortex(small_cell()));
}

TEST(Actomyosin, IsImplicitAcrossEachSegment) { // time_step T/l on the relative velocity across it
  const CortexState c = wavy_cortex(small_cell());
  const std::vector<double> f_mat = uneven_maturation(c);
  const std::vector<Vec2> v = stirred(c.size());
  double expected = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::size_t j = c.next(i);
    const Vec2 e = c.x[j] - c.x[i];
    const double T = tension(std::min(f_mat[i], f_mat[j]), 0.5 * (curvature(c, i) + curvature(c, j)));
    expected += time_step * T / e.norm() * std::pow(cross(e, v[j] - v[i]) / e.norm(), 2);
  }
  EXPECT_NEAR(power(drag_force(assemble(actomyosin(uneven_maturation), c).A, v), v), expected, 1e-12 * expected);
}

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

TEST(RestLength, FollowsAShorteningSegmentDownToItsInitialLength) {
  constexpr double initial = 0.4;
  struct Row {
    double l0, l, expected;
  };
  for (const Row& row : {Row{0.8, 0.6, 0.6},   // shortened: remembered
                         Row{0.8, 0.9, 0.8},   // stretched: springs back
                         Row{0.8, 0.8, 0.8},   //
                         Row{0.8, 0.4, 0.4},   // as far as the initial length
                         Row{0.8, 0.39, 0.8},  // not below it
                         Row{0.4, 0.39, 0.4},  // unstretched
                         Row{0.3, 0.35, 0.3}}) // shorter than initially, stretched
    EXPECT_EQ(ratcheted(row.l0, row.l, initial), row.expected) << row.l0 << " -> " << row.l;
}

TEST(RestLength, RatchetsAllSegmentsButTheSoftOnes) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  const double initial = initial_segment_length(p);
  for (Vec2& x : c.x) x *= 1.2;
  c.l0.assign(c.size(), 1.5 * initial);
  std::vector<std::uint8_t> soft(c.size(), 0);
  for (std::size_t i = 10; i < 20; ++i) soft[i] = 1;
  ratchet_rest_lengths(c, p, soft);
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(c.l0[i], (soft[i] ? 1.5 : 1.2) * initial, 1e-12);
}

TEST(RestLength, OfTheUnstretchedCellStays) {
  const CellParameters p = small_cell();
  CortexState c = round_cortex(p);
  const std::vector<double> before = c.l0;
  for (const double scale : {0.7, 1.3}) {
    for (std::size_t i = 0; i < c.size(); ++i) c.x[i] *= scale;
    ratchet_rest_lengths(c, p, std::vector<std::uint8_t>(c.size(), 0));
    EXPECT_EQ(c.l0, before);
  }
}

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
