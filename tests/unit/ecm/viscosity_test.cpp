#include "ecm/viscosity.hpp"

#include "body.hpp"
#include "sph/neighbours.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

struct Assembled {
  explicit Assembled(const EcmState& ecm) {
    const Adjacency pairs = neighbours_within(ecm.x, 6.2, ecm.period_x);
    assemble_viscosity(ecm, EcmParameters{}, RowPattern(pairs, ecm.clamped), A);
  }
  Eigen::MatrixXd dense() const {
    const auto n = static_cast<Eigen::Index>(A.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < A.size(); ++i) {
      M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = A.diagonal[i];
      A.pairs.each_of_row(
          i, [&](std::size_t j, float G) { M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = -G; });
    }
    return M;
  }
  DragSystem A;
};

} // namespace

TEST(PairDrag, IsThatOfEquation2) {
  const double h = 2.6;
  const Kernel kernel(h);
  const Vec2 x_ij(2.0, 1.0);
  const double r = x_ij.norm();
  const Vec2 grad_W = kernel.W_slope(r) * x_ij;
  EXPECT_DOUBLE_EQ(pair_drag(r * r, kernel.W_slope(r), 4.0, 1.5, 0.7, h),
                   0.7 * 4.0 * 4.0 * (1.5 + 1.5) * (-x_ij.dot(grad_W)) / (r * r + 0.01 * h * h));
  EXPECT_EQ(pair_drag(36.0, kernel.W_slope(6.0), 4.0, 1.0, 1.0, h), 0.0);
}

TEST(DragMatrix, IsSymmetricToTheBitAndPositiveDefinite) {
  EcmState ecm = deformed_body(EcmParameters{});
  for (std::size_t i = 0; i < 15; ++i) ecm.clamped[i] = 1;
  const Eigen::MatrixXd M = Assembled(ecm).dense();
  EXPECT_TRUE(M == M.transpose());
  EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(M).info(), Eigen::Success);
}

TEST(DragMatrix, WithoutClampTheForcesOfAnyMotionSumToZero) {
  const EcmState ecm = deformed_body(EcmParameters{});
  const Assembled a(ecm);
  std::vector<Vec2> force(ecm.size());
  multiply(a.A, ecm.v, force);
  Vec2 sum = Vec2::Zero();
  double magnitude = 0.0;
  for (const Vec2& f : force) {
    sum += f;
    magnitude += f.norm();
  }
  EXPECT_GT(magnitude, 1.0);
  EXPECT_LT(sum.norm(), 1e-14 * magnitude);
  const std::vector<Vec2> translation(ecm.size(), Vec2(0.3, -0.4));
  multiply(a.A, translation, force);
  for (const Vec2& f : force) EXPECT_NEAR(f.norm(), 0.0, 1e-14);
}

TEST(DragMatrix, AClampDragsItsNeighboursAlong) {
  EcmState ecm = deformed_body(EcmParameters{});
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.clamped[i] = i < 30 ? 1 : 0;
    ecm.v[i] = Vec2(0.2, 0.1);
  }
  const Assembled a(ecm);
  std::vector<Vec2> force(ecm.size());
  multiply(a.A, ecm.v, force); // all move with the clamp: A v = F exactly
  for (std::size_t i = 0; i < ecm.size(); ++i) EXPECT_NEAR((force[i] - a.A.F[i]).norm(), 0.0, 1e-14);
}

TEST(DragMatrix, ALonelyParticleStays) {
  EcmState ecm = rectangle(EcmParameters{}, 10.0, 10.0, 0.0);
  ecm.x[0] = Vec2(500.0, 500.0);
  const Assembled a(ecm);
  EXPECT_EQ(a.A.diagonal[0], 1.0);
  EXPECT_EQ(a.A.F[0].norm(), 0.0);
}

TEST(DragMatrix, AShareAgainstChangesOfVelocityChangesNothingAtThePresentOnes) {
  EcmState ecm = deformed_body(EcmParameters{});
  for (std::size_t i = 0; i < 30; ++i) ecm.clamped[i] = 1;
  const Assembled a(ecm);
  DragSystem B;
  const Adjacency pairs = neighbours_within(ecm.x, 6.2, ecm.period_x);
  assemble_viscosity(ecm, EcmParameters{}, RowPattern(pairs, ecm.clamped), B, 0.5);
  std::vector<Vec2> r(ecm.size()), r_B(ecm.size());
  ResidualFields fields;
  residual(a.A, a.A.F, ecm.v, r, fields);
  residual(B, B.F, ecm.v, r_B, fields);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_LT((r[i] - r_B[i]).norm(), 1e-5);
    EXPECT_NEAR(B.diagonal[i], (ecm.clamped[i] ? 1.0 : 1.5) * a.A.diagonal[i], 1e-5 * a.A.diagonal[i]);
  }
}
