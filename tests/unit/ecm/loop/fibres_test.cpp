#include "ecm/loop/fibres.hpp"

#include "ecm/loop/viscosity.hpp"
#include "sph/neighbours.hpp"
#include "unit/ecm/body.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

using namespace matrigrate;

namespace {

FibreParameters isotropic() {
  FibreParameters p;
  p.arrangement = FibreArrangement::isotropic;
  return p;
}

std::vector<Vec2> forces(const EcmState& ecm, const EcmParameters& p, const FibreParameters& fibres,
                         const FibreNetwork& network, DragSystem* drag = nullptr) {
  const Adjacency pairs = neighbours_within(ecm.x, 2.0 * p.smoothing_length + 0.5, ecm.period_x);
  DragSystem A;
  assemble_viscosity(ecm, p, RowPattern(pairs, ecm.clamped), A);
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  add_fibre_forces(ecm, p, fibres, network, 0.4, force, A);
  if (drag != nullptr) *drag = A;
  return force;
}

/// A free body stretched along x by lx and along y by ly.
EcmState stretched(const EcmParameters& p, double lx, double ly) {
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] = Vec2(lx * ecm.X[i].x(), ly * ecm.X[i].y());
  return ecm;
}

constexpr std::size_t middle = 10 * 20 + 10;

} // namespace

TEST(FibreLaw, IsSoftInCompressionAndStiffensExponentiallyBeyondTheOnset) {
  const FibreParameters p;
  EXPECT_EQ(fibre_stiffness(-0.1, p), 0.0);
  EXPECT_EQ(fibre_tension(-0.1, p), 0.0);
  EXPECT_EQ(fibre_stiffness(0.0, p), 1.0);
  EXPECT_EQ(fibre_stiffness(0.075, p), 1.0);
  EXPECT_NEAR(fibre_stiffness(0.075 + 0.033, p), std::exp(1.0), 1e-12);
  EXPECT_DOUBLE_EQ(fibre_tension(0.05, p), 0.05);
  EXPECT_NEAR(fibre_tension(0.108, p), 0.075 + 0.033 * (std::exp(1.0) - 1.0), 1e-12);
}

TEST(FibreLaw, TensionIsTheSlopeOfTheEnergyAndHasTheStatedSlope) {
  constexpr double h = 1e-6;
  const FibreParameters p;
  for (const double strain : {-0.2, 0.03, 0.07, 0.08, 0.12, 0.2}) {
    EXPECT_NEAR((fibre_energy(strain + h, p) - fibre_energy(strain - h, p)) / (2.0 * h), fibre_tension(strain, p),
                1e-7 * (1.0 + fibre_tension(strain, p)));
    EXPECT_NEAR((fibre_tension(strain + h, p) - fibre_tension(strain - h, p)) / (2.0 * h), fibre_stiffness(strain, p),
                1e-6 * (1.0 + fibre_stiffness(strain, p)));
  }
}

TEST(FibreNetwork, WeightsAreSymmetricAndSumToOneWithTheParticleItself) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  const FibreNetwork network(ecm, p, isotropic(), ref);
  const Adjacency& pairs = network.pairs();
  EXPECT_EQ(pairs.index, ref.pairs().index);
  double sum = 0.0;
  for (std::uint32_t k = pairs.first[middle]; k < pairs.first[middle + 1]; ++k) sum += network.weight(k);
  const Kernel kernel(p.smoothing_length);
  double W = kernel.W(0.0);
  for (const Vec2& X : lattice_patch(p, kernel.support()))
    if (X.norm() > 0.0) W += kernel.W(X.norm());
  EXPECT_NEAR(sum, 1.0 - kernel.W(0.0) / W, 1e-12);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
      const auto row = pairs.of(pairs.index[k]);
      const auto back = pairs.first[pairs.index[k]]
                        + static_cast<std::uint32_t>(std::lower_bound(row.begin(), row.end(), i) - row.begin());
      EXPECT_EQ(network.weight(k), network.weight(back));
    }
}

TEST(FibreNetwork, OfAUniaxialMatrixJoinsPairsWithinTheAngleBoundaryIncluded) {
  FibreParameters p = isotropic();
  p.arrangement = FibreArrangement::uniaxial;
  for (const double direction : {0.0, 37.0, -120.0}) {
    p.direction_deg = direction;
    const auto at = [&](double degrees) {
      const double a = (direction + degrees) * std::numbers::pi / 180.0;
      return Vec2(3.0 * std::cos(a), 3.0 * std::sin(a));
    };
    for (const double inside : {0.0, 29.0, 30.0, -30.0, 180.0, 150.0, 210.0}) EXPECT_TRUE(joined(at(inside), p));
    for (const double outside : {31.0, -31.0, 90.0, 149.0}) EXPECT_FALSE(joined(at(outside), p));
  }
}

TEST(FibreForces, VanishAtRestAndInCompression) {
  const EcmParameters p;
  for (const double scale : {1.0, 0.9}) {
    const EcmState ecm = stretched(p, scale, scale);
    const FibreNetwork network(ecm, p, isotropic(), Reference(ecm, p));
    for (const Vec2& f : forces(ecm, p, isotropic(), network)) EXPECT_EQ(f.norm(), 0.0);
  }
}

TEST(FibreForces, ConserveLinearAndAngularMomentum) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const FibreNetwork network(ecm, p, isotropic(), Reference(ecm, p));
  const std::vector<Vec2> force = forces(ecm, p, isotropic(), network);
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, magnitude = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    sum += force[i];
    torque += cross(ecm.x[i], force[i]);
    magnitude += force[i].norm();
    moment += ecm.x[i].norm() * force[i].norm();
  }
  EXPECT_GT(magnitude, 0.1);
  EXPECT_LT(sum.norm(), 1e-14 * magnitude);
  EXPECT_LT(std::abs(torque), 1e-14 * moment);
}

TEST(FibreForces, AreMinusTheGradientOfTheirEnergy) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const FibreParameters fibres = isotropic();
  const FibreNetwork network(ecm, p, fibres, Reference(ecm, p));
  const std::vector<Vec2> force = forces(ecm, p, fibres, network);
  constexpr double h = 1e-5;
  for (const std::size_t i : {0UL, 20UL, 60UL, 90UL, 111UL})
    for (int c = 0; c < 2; ++c) {
      const double at = ecm.x[i](c);
      ecm.x[i](c) = at + h;
      const double up = fibre_energy(ecm, fibres, network);
      ecm.x[i](c) = at - h;
      const double down = fibre_energy(ecm, fibres, network);
      ecm.x[i](c) = at;
      EXPECT_NEAR(force[i](c), -p.thickness * (up - down) / (2.0 * h), 1e-7 * (1.0 + force[i].norm()));
    }
}

TEST(FibreForces, TurnWithTheBody) {
  const EcmParameters p;
  const EcmState before = deformed_body(p);
  EcmState after = before;
  const Mat2 R = Eigen::Rotation2Dd(0.8).toRotationMatrix();
  for (Vec2& x : after.x) x = R * x + Vec2(5.0, -2.0);
  const FibreNetwork network(before, p, isotropic(), Reference(before, p));
  const std::vector<Vec2> a = forces(before, p, isotropic(), network);
  const std::vector<Vec2> b = forces(after, p, isotropic(), network);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((b[i] - R * a[i]).norm(), 1e-12);
}

TEST(FibreForces, FluidCarriesNone) {
  const EcmParameters p;
  EcmState ecm = stretched(p, 1.1, 1.1);
  const FibreNetwork network(ecm, p, isotropic(), Reference(ecm, p));
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.X[i].x() > 0.0) ecm.f[i] = 0.0;
  const std::vector<Vec2> force = forces(ecm, p, isotropic(), network);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.X[i].x() > 0.0) {
      EXPECT_EQ(force[i].norm(), 0.0);
      EXPECT_EQ(fibre_stress(ecm, isotropic(), network, i).norm(), 0.0);
    }
  }
}

TEST(FibreForces, WhatStiffensBeyondKZeroEntersTheDrag) {
  const EcmParameters p;
  for (const double stretch : {1.05, 1.15}) {
    const EcmState ecm = stretched(p, stretch, 1.0);
    const FibreNetwork network(ecm, p, isotropic(), Reference(ecm, p));
    const FibreNetwork none;
    DragSystem with, without;
    forces(ecm, p, isotropic(), network, &with);
    forces(ecm, p, isotropic(), none, &without);
    const double added = with.diagonal[middle] - without.diagonal[middle];
    if (stretch < 1.075) {
      EXPECT_EQ(added, 0.0);
    } else {
      EXPECT_GT(added, 0.1);
      double row = 0.0;
      double diagonal = 0.0;
      for (std::size_t i = 0; i < ecm.size(); ++i) {
        with.pairs.each_of_row(i, [&](std::size_t, float G) { row += static_cast<double>(G); });
        without.pairs.each_of_row(i, [&](std::size_t, float G) { row -= static_cast<double>(G); });
        diagonal += with.diagonal[i] - without.diagonal[i];
      }
      EXPECT_NEAR(row, diagonal, 1e-9 * diagonal); // it resists relative motion alone
    }
  }
}

// Eq. (11) on a lattice under homogeneous stretch against the work that a stretch does: P = dW/dF.
TEST(FibreStress, IsConjugateToHomogeneousStretch) {
  const EcmParameters p;
  for (const FibreArrangement arrangement : {FibreArrangement::isotropic, FibreArrangement::uniaxial}) {
    FibreParameters fibres = isotropic();
    fibres.arrangement = arrangement;
    const double lx = 1.09, ly = 0.96;
    EcmState ecm = stretched(p, lx, ly);
    const FibreNetwork network(ecm, p, fibres, Reference(ecm, p));
    ecm.rho[middle] = 1.0 / (lx * ly);
    const Mat2 sigma = fibre_stress(ecm, fibres, network, middle);
    // energy per reference area of the particle in the middle: half of each of its fibres
    const auto energy = [&](double ax, double ay) {
      double sum = 0.0;
      for (std::uint32_t k = network.pairs().first[middle]; k < network.pairs().first[middle + 1]; ++k) {
        const Vec2& X = network.X_ij(k);
        const double strain = Vec2(ax * X.x(), ay * X.y()).norm() / X.norm() - 1.0;
        sum += 0.5 * network.weight(k) * X.squaredNorm() * fibre_energy(strain, fibres);
      }
      return sum / ecm.V0;
    };
    constexpr double h = 1e-6;
    const double P_xx = (energy(lx + h, ly) - energy(lx - h, ly)) / (2.0 * h);
    const double P_yy = (energy(lx, ly + h) - energy(lx, ly - h)) / (2.0 * h);
    EXPECT_NEAR(sigma(0, 0), P_xx / ly, 1e-8); // sigma = P F^T / J
    EXPECT_NEAR(sigma(1, 1), P_yy / lx, 1e-8);
    EXPECT_NEAR(sigma(0, 1), 0.0, 1e-12);
    EXPECT_GT(sigma(0, 0), 1e-3);
  }
}

TEST(PlaneVonMises, OfSimpleStates) {
  EXPECT_NEAR(plane_von_mises((Mat2() << 3.0, 0.0, 0.0, 0.0).finished()), 3.0, 1e-12);
  EXPECT_NEAR(plane_von_mises((Mat2() << 2.0, 0.0, 0.0, 2.0).finished()), 2.0, 1e-12);
  EXPECT_NEAR(plane_von_mises((Mat2() << 0.0, 1.0, 1.0, 0.0).finished()), std::sqrt(3.0), 1e-12);
  EXPECT_EQ(plane_von_mises(Mat2::Zero()), 0.0);
}
