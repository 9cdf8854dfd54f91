#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "ecm/loop/fluid.hpp"
#include "ecm/loop/rows.hpp"
#include "ecm/loop/stress.hpp"
#include "ecm/loop/viscosity.hpp"
#include "sph/neighbours.hpp"
#include "unit/ecm/body.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>

using namespace matrigrate;

TEST(Deformation, IsExactForEveryLinearField) {
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
    EcmParameters p;
    p.lattice = lattice;
    EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
    for (std::size_t i = 0; i < ecm.size(); i += 4) ecm.f[i] = 0.5; // whatever the state of degradation
    const Reference ref(ecm, p);
    const Mat2 H = (Mat2() << 0.3, -0.2, 0.5, -0.1).finished();
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      ecm.x[i] = ecm.X[i] + H * ecm.X[i] + Vec2(3.0, 4.0);
      ecm.v[i] = H * ecm.X[i];
    }
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      EXPECT_NEAR((deformation_gradient(ecm, ref, i) - Mat2::Identity() - H).norm(), 0.0, 1e-12);
      EXPECT_NEAR((deformation_rate(ecm, ref, i) - H).norm(), 0.0, 1e-12);
    }
  }
}

TEST(Deformation, RateIsTheDerivativeOfTheGradient) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const double dt = 1e-6;
  EcmState later = ecm;
  for (std::size_t i = 0; i < ecm.size(); ++i) later.x[i] += dt * ecm.v[i];
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const Mat2 difference = (deformation_gradient(later, ref, i) - deformation_gradient(ecm, ref, i)) / dt;
    EXPECT_NEAR((difference - deformation_rate(ecm, ref, i)).norm(), 0.0, 1e-8);
  }
}

namespace {

/// Everything scaled about the origin.
EcmState squeezed(double f, double scale) {
  EcmState ecm = rectangle(EcmParameters{}, 40.0, 40.0, 0.0);
  std::fill(ecm.f.begin(), ecm.f.end(), f);
  for (Vec2& x : ecm.x) x *= scale;
  return ecm;
}

double middle_pressure(const EcmState& ecm) {
  const EcmParameters p;
  return fluid_pressure(ecm, p, neighbours_within(ecm.x, 5.2, 0.0), Kernel(2.6), lattice_density(p), 10 * 20 + 10);
}

} // namespace

TEST(FluidPressure, IsNoneAtTheDensityOfTheLatticeAndUnderTension) {
  EXPECT_NEAR(middle_pressure(squeezed(0.0, 1.0)), 0.0, 1e-12);
  EXPECT_EQ(middle_pressure(squeezed(0.0, 1.05)), 0.0);
}

TEST(FluidPressure, FollowsTheEquationOfState) {
  const double K = moduli(EcmParameters{}).K;
  const double scale = 0.99;
  const double rise = 1.0 / (scale * scale) - 1.0;
  EXPECT_NEAR(middle_pressure(squeezed(0.0, scale)), K * rise, 0.05 * K * rise); // summed density: a few per cent
  EXPECT_NEAR(middle_pressure(squeezed(0.5, scale)), 0.5 * middle_pressure(squeezed(0.0, scale)), 1e-12);
  EXPECT_EQ(middle_pressure(squeezed(1.0, scale)), 0.0);
}

TEST(FluidForces, PushApartAndKeepMomentum) {
  const EcmParameters p;
  const EcmState ecm = squeezed(0.0, 0.95);
  const Adjacency pairs = neighbours_within(ecm.x, 5.2, 0.0);
  std::vector<double> pressure;
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  find_fluid_pressures(ecm, p, pairs, pressure);
  add_fluid_forces(ecm, p, pairs, pressure, force);
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, outwards = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    sum += force[i];
    torque += cross(ecm.x[i], force[i]);
    outwards += ecm.x[i].dot(force[i]);
  }
  EXPECT_NEAR(sum.norm(), 0.0, 1e-14);
  EXPECT_NEAR(torque, 0.0, 1e-13);
  EXPECT_GT(outwards, 0.1);
}

TEST(FluidForces, PushAWallOfSolidWithHalfTheirPressure) { // the solid has no pressure of its own in these sums
  const EcmParameters p;
  EcmState ecm = strip(p, 24.0, 60.0);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.f[i] = ecm.X[i].y() < 0.0 ? 0.0 : 1.0;
    ecm.x[i].y() *= 0.97;
  }
  const Adjacency pairs = neighbours_within(ecm.x, 5.2, ecm.period_x);
  std::vector<double> pressure;
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  find_fluid_pressures(ecm, p, pairs, pressure);
  add_fluid_forces(ecm, p, pairs, pressure, force);
  double on_wall = 0.0;
  double deep = 0.0; // pressure of the fluid away from the wall
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] > 0.0) on_wall += force[i].y();
    if (std::abs(ecm.X[i].y() + 15.0) < 1.1) deep = pressure[i];
  }
  ASSERT_GT(deep, 0.0);
  EXPECT_NEAR(on_wall / (ecm.period_x * p.thickness * deep), 0.5, 0.03);
}

namespace {

/// Every particle in one row, in order; every partner of every particle among those of its row, and no other.
/// @return the number of particles in long rows
std::size_t check_rows(const EcmState& ecm, const Reference& ref) {
  std::mutex one_at_a_time;
  std::vector<int> seen(ecm.size());
  std::size_t in_long_ones = 0;
  ref.each_row([&](const RowTerms& terms) {
    const std::scoped_lock lock(one_at_a_time);
    const ParticleRow& row = terms.row;
    EXPECT_LE(row.count, row.ragged ? ParticleRows::lanes : ParticleRow::longest);
    EXPECT_TRUE(row.ragged || row.count >= ParticleRows::lanes);
    if (row.count > 20) in_long_ones += row.count;
    for (std::uint32_t t = 0; t < row.count; ++t) {
      const std::size_t i = row.begin + t;
      ++seen[i];
      std::vector<std::uint32_t> partners;
      for (std::size_t k = 0; k < terms.partners.size(); ++k) {
        if (row.ragged && terms.has[ParticleRows::lanes * k + t] == 0.0) continue;
        const RowPartner& j = terms.partners[k];
        const auto partner = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + j.distance);
        partners.push_back(static_cast<std::uint32_t>(partner));
        EXPECT_LT((nearest_image(ecm.X[i] - ecm.X[partner], ecm.period_x) - 2.0 * Vec2(j.half_X, j.half_Y)).norm(),
                  1e-9);
      }
      const auto expected = ref.pairs().of(i);
      EXPECT_TRUE(std::ranges::equal(partners, expected)) << "particle " << i;
    }
  });
  EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(ecm.size()));
  return in_long_ones;
}

} // namespace

TEST(Rows, HoldEveryPartnerOfEveryParticleAndAreLongOnALattice) {
  Parameters p;
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
    p.ecm.lattice = lattice;
    const EcmState ecm = disc(p);
    EXPECT_GT(check_rows(ecm, Reference(ecm, p.ecm)), 17 * ecm.size() / 20);
  }
}

TEST(Rows, HoldEveryPartnerWhereTheMatrixRepeatsAndWhereItIsNarrow) {
  const EcmParameters p;
  for (const double width : {16.0, 24.0, 40.0}) {
    const EcmState periodic = strip(p, width, 20.0);
    check_rows(periodic, Reference(periodic, p));
    const EcmState free = rectangle(p, 0.5 * width, 20.0, 0.0);
    check_rows(free, Reference(free, p));
  }
}

TEST(Rows, GradientsEqualThoseOfSingleParticles) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  VectorPlanes u, v;
  u.resize(ecm.size());
  v.resize(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    u.set(i, ecm.f[i] * ecm.displacement(i));
    v.set(i, ecm.f[i] * ecm.v[i]);
  }
  std::atomic<std::size_t> seen = 0;
  ref.each_row([&](const RowTerms& terms) {
    RowTensors H, rate;
    row_gradients(
        ecm, ref, terms, u, [&](std::size_t i) { return ecm.displacement(i); }, H);
    row_gradients(
        ecm, ref, terms, v, [&](std::size_t i) { return ecm.v[i]; }, rate);
    for (std::size_t t = 0; t < terms.row.count; ++t, ++seen) {
      const std::size_t i = terms.row.begin + t;
      const bool solid = ecm.f[i] > 0.0;
      const Mat2 F = solid ? deformation_gradient(ecm, ref, i) : Mat2(Mat2::Identity());
      EXPECT_LT((Mat2::Identity() + H[t] - F).norm(), 1e-13);
      EXPECT_LT((rate[t] - (solid ? deformation_rate(ecm, ref, i) : Mat2(Mat2::Zero()))).norm(), 1e-13);
    }
  });
  EXPECT_EQ(seen, ecm.size());
}

TEST(Rows, ForcesEqualThoseOfSinglePairs) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  VectorPlanes u;
  TensorPlanes H, Q;
  u.resize(ecm.size());
  H.resize(ecm.size());
  Q.resize(ecm.size());
  std::vector<Mat2> F(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    u.set(i, ecm.f[i] * ecm.displacement(i));
    F[i] = deformation_gradient(ecm, ref, i);
    H.set(i, ecm.f[i] * (F[i] - Mat2::Identity()));
    Q.set(i, ecm.f[i] * ecm.S[i]);
  }
  std::atomic<std::size_t> seen = 0;
  ref.each_row([&](const RowTerms& terms) {
    RowVectors stress, hourglass;
    RowTensors moment;
    sum_hourglass(terms, u, H, moment, hourglass);
    sum_stress(terms, Q, stress);
    for (std::size_t t = 0; t < terms.row.count; ++t, ++seen) {
      const std::size_t i = terms.row.begin + t;
      Vec2 of_stress = Vec2::Zero(), of_hourglass = Vec2::Zero();
      Mat2 of_moment = Mat2::Zero();
      for (std::uint32_t k = ref.pairs().first[i]; k < ref.pairs().first[i + 1]; ++k) {
        const double f = ecm.f[ref.pairs().index[k]];
        const Vec2 e = hourglass_error(ecm, ref, F, i, k);
        of_stress += f * (ecm.S[i] + ecm.S[ref.pairs().index[k]]) * ref.grad_W(k);
        of_hourglass += f * ref.W_over_r2(k) * e;
        of_moment += f * ref.W_over_r2(k) * e * ref.X_ij(k).transpose();
      }
      const DegradationMoments& m = ref.moments(i);
      const Mat2 own = 0.5 * (F[i] - Mat2::Identity());
      const Vec2 u_i = ecm.displacement(i);
      EXPECT_LT((stress[t] + ecm.S[i] * m.grad_W - of_stress).norm(), 1e-13);
      EXPECT_LT((hourglass[t] + own * m.wX - u_i * m.w - of_hourglass).norm(), 1e-12);
      EXPECT_LT((moment[t] + own * m.wXX - u_i * m.wX.transpose() - of_moment).norm(), 1e-12);
    }
  });
  EXPECT_EQ(seen, ecm.size());
}

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
