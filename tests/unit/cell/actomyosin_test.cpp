#include "cell/actomyosin.hpp"

#include "cell/geometry.hpp"
#include "ring.hpp"

using namespace matrigrate;

namespace {

std::vector<double> uneven_maturation(const CortexState& c) {
  std::vector<double> f_mat;
  for (std::size_t i = 0; i < c.size(); ++i) f_mat.push_back(0.3 + 0.2 * std::sin(static_cast<double>(i)));
  return f_mat;
}

CortexForce actomyosin(const std::function<std::vector<double>(const CortexState&)>& f_mat) {
  return [f_mat](const CortexState& c, std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
    add_actomyosin(c, {}, f_mat(c), time_step, first, force, A);
  };
}

} // namespace

TEST(CurvatureFactor, IsOneAtTheOptimumAndSymmetricAroundIt) {
  const ActomyosinParameters p;
  EXPECT_EQ(curvature_factor(-0.15, p), 1.0);
  for (double q = 0.0; q < 2.0; q += 0.05) {
    const double factor = curvature_factor(-0.15 + q, p);
    EXPECT_NEAR(curvature_factor(-0.15 - q, p), factor, 1e-14);
    EXPECT_LE(curvature_factor(-0.15 + q + 0.05, p), factor);
    EXPECT_GE(factor, 0.0);
  }
  EXPECT_LT(curvature_factor(3.0, p), 1e-9);
  EXPECT_LT(curvature_factor(-3.0, p), 1e-9);
}

TEST(CurvatureFactor, FallsToOneOverEAtOneWidth) {
  EXPECT_NEAR(curvature_factor(0.10, ActomyosinParameters{}), std::exp(-1.0), 1e-12);
}

TEST(CurvatureFactor, OfTheRoundBodyIsSmallerThanOfAConcaveFlank) {
  const ActomyosinParameters p;
  EXPECT_NEAR(curvature_factor(1.0 / 15.0, p), std::exp(-std::pow((1.0 / 15.0 + 0.15) / 0.25, 2)), 1e-12); // 0.47
  EXPECT_NEAR(curvature_factor(-0.1, p), std::exp(-0.04), 1e-12);
}

TEST(Eq6, TakesTheLesserMaturationOfBothEnds) {
  const ActomyosinParameters p;
  EXPECT_DOUBLE_EQ(F_am(1.0, 1.0, -0.15, p), 0.6);
  EXPECT_DOUBLE_EQ(F_am(0.2, 0.7, -0.15, p), 0.12);
  EXPECT_DOUBLE_EQ(F_am(0.7, 0.2, -0.15, p), 0.12);
  EXPECT_EQ(F_am(0.0, 1.0, -0.15, p), 0.0);
  EXPECT_DOUBLE_EQ(F_am(0.2, 0.7, 0.2, p), 0.12 * curvature_factor(0.2, p));
}

TEST(Actomyosin, ContractsTheRoundCell) {
  const CellParameters cell;
  const ActomyosinParameters p;
  const CortexState c = round_cortex(cell);
  const auto body = [](const CortexState& ring) { return std::vector<double>(ring.size(), 0.05); };
  const std::vector<Vec2> force = assemble(actomyosin(body), c).force;
  const double inwards = 2.0 * F_am(0.05, 0.05, 1.0 / 15.0, p) * std::sin(std::numbers::pi / 235.0);
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
  const ActomyosinParameters p;
  const CortexState c = wavy_cortex(small_cell());
  std::vector<double> f_mat(c.size(), 0.0);
  f_mat[5] = f_mat[6] = 0.8; // the tension of a single segment
  const std::vector<Vec2> force = assemble(actomyosin([&](const CortexState&) { return f_mat; }), c).force;
  const double kappa = 0.5 * (curvature(c, 5) + curvature(c, 6));
  EXPECT_GT(std::abs(curvature(c, 5) - kappa), 1e-3);
  EXPECT_LT((force[5] - F_am(0.8, 0.8, kappa, p) * (c.x[6] - c.x[5]).normalized()).norm(), 1e-15);
  EXPECT_LT((force[6] + force[5]).norm(), 1e-15);
}

TEST(Actomyosin, ObeysTheLawsOfInternalForces) {
  expect_internal(actomyosin(uneven_maturation), wavy_cortex(small_cell()));
}

TEST(Actomyosin, IsImplicitAcrossEachSegment) { // time_step T/l on the relative velocity across it
  const ActomyosinParameters p;
  const CortexState c = wavy_cortex(small_cell());
  const std::vector<double> f_mat = uneven_maturation(c);
  const std::vector<Vec2> v = stirred(c.size());
  double expected = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::size_t j = c.next(i);
    const Vec2 e = c.x[j] - c.x[i];
    const double T = F_am(f_mat[i], f_mat[j], 0.5 * (curvature(c, i) + curvature(c, j)), p);
    expected += time_step * T / e.norm() * std::pow(cross(e, v[j] - v[i]) / e.norm(), 2);
  }
  EXPECT_NEAR(power(drag_force(assemble(actomyosin(uneven_maturation), c).A, v), v), expected, 1e-12 * expected);
}
