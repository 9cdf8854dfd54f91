#include "ecm/loop/viscosity.hpp"

#include "sph/neighbours.hpp"
#include "unit/ecm/body.hpp"
#include "unit/ecm/same_drag.hpp"

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
    const double of_all = ecm.clamped[i] ? 1.0 : 1.5; // the system is divided by it
    EXPECT_LT((r[i] - of_all * r_B[i]).norm(), 1e-5);
    EXPECT_EQ(B.diagonal[i], a.A.diagonal[i]);
  }
}

TEST(ViscosityRows, HaveTheSameBitsAsIfAllWereComputed) {
  const EcmParameters p;
  for (const bool clamp_moves : {false, true}) {
    EcmState ecm = deformed_body(p);
    for (std::size_t i = 0; i < 30; ++i) ecm.clamped[i] = 1;
    if (!clamp_moves)
      for (std::size_t i = 0; i < 30; ++i) ecm.v[i].setZero();
    const Adjacency pairs = neighbours_within(ecm.x, 8.0, ecm.period_x);
    const RowPattern pattern(pairs, ecm.clamped);
    ViscosityRows rows;
    DragSystem kept;
    for (int step = 0; step < 4; ++step) {
      rows.assemble(ecm, ecm.x, p, pairs, pattern, {}, 0.3, kept);
      DragSystem all;
      assemble_viscosity(ecm, p, pattern, all, 0.3);
      expect_same(kept, all);
      for (std::size_t i = 0; i < ecm.size(); i += 37) ecm.x[i] += Vec2(0.1 * step, -0.2);
    }
    const Adjacency fewer = neighbours_within(ecm.x, 7.0, ecm.period_x);
    const RowPattern other(fewer, ecm.clamped);
    rows.assemble(ecm, ecm.x, p, fewer, other, std::vector<std::uint8_t>(ecm.size(), 1), 0.3, kept);
    DragSystem all;
    assemble_viscosity(ecm, p, other, all, 0.3);
    expect_same(kept, all);
  }
}
