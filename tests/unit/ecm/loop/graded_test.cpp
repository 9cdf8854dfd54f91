#include "ecm/loop/stress.hpp"

#include "base/random.hpp"
#include "ecm/loop/deformation.hpp"
#include "ecm/loop/fibres.hpp"
#include "ecm/loop/fluid.hpp"
#include "sph/neighbours.hpp"
#include "unit/ecm/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

using namespace matrigrate;

namespace {

std::vector<Vec2> elastic_forces(const EcmState& ecm, const EcmParameters& p, const Reference& ref) {
  std::vector<Vec2> force(ecm.size(), Vec2::Zero());
  SolidFields solid;
  add_elastic_forces(ecm, p, ref, solid, force);
  return force;
}

/// The deformed, partly degraded body with a Young's modulus of its own for each particle, from 0.2 to 3.2 E.
EcmState uneven_body(const EcmParameters& p) {
  EcmState ecm = deformed_body(p);
  for (std::uint32_t i = 0; i < ecm.size(); ++i) ecm.E_ratio.push_back(0.2 + 3.0 * uniform(1, Purpose::test, 0, i));
  return ecm;
}

EcmParameters stiffer(EcmParameters p, double ratio) {
  p.youngs_modulus *= ratio;
  return p;
}

double largest(const std::vector<Vec2>& force) {
  double most = 0.0;
  for (const Vec2& f : force) most = std::max(most, f.norm());
  return most;
}

} // namespace

TEST(GradedForces, OfAConstantFieldAreThoseOfAUniformMatrix) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  for (const double ratio : {1.0, 2.5}) {
    ecm.E_ratio.clear();
    const std::vector<Vec2> expected = elastic_forces(ecm, stiffer(p, ratio), ref);
    ecm.E_ratio.assign(ecm.size(), ratio);
    const std::vector<Vec2> graded = elastic_forces(ecm, p, ref);
    for (std::size_t i = 0; i < ecm.size(); ++i)
      EXPECT_LT((graded[i] - expected[i]).norm(), 1e-14 * largest(expected)) << i;
  }
}

TEST(GradedForces, HaveNoNetForceAndNoTorque) {
  const EcmParameters p;
  const EcmState ecm = uneven_body(p);
  const std::vector<Vec2> force = elastic_forces(ecm, p, Reference(ecm, p));
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
  EXPECT_LT(std::abs(torque), 1e-13 * moment);
}

TEST(GradedForces, AreTheGradientOfTheHourglassEnergy) {
  const EcmParameters p;
  EcmState ecm = uneven_body(p);
  std::fill(ecm.S.begin(), ecm.S.end(), Mat2::Zero());
  std::fill(ecm.rho.begin(), ecm.rho.end(), 1.0); // no stress: only the penalty acts
  const Reference ref(ecm, p);
  const auto energy = [&](const EcmState& moved) {
    std::vector<Mat2> F(moved.size(), Mat2::Identity());
    for (std::size_t i = 0; i < moved.size(); ++i)
      if (moved.f[i] > 0.0) F[i] = deformation_gradient(moved, ref, i);
    return hourglass_energy(moved, p, ref, F);
  };
  const std::vector<Vec2> force = elastic_forces(ecm, p, ref);
  const double d = 1e-4;
  for (const std::size_t i : {0UL, 17UL, 60UL, 111UL, 140UL})
    for (int c = 0; c < 2; ++c) {
      EcmState moved = ecm;
      moved.x[i](c) += d;
      const double up = energy(moved);
      moved.x[i](c) -= 2.0 * d;
      EXPECT_NEAR(force[i](c), -p.thickness * (up - energy(moved)) / (2.0 * d), 1e-10) << i;
    }
}

TEST(GradedStress, GrowsWithTheModulusOfTheParticle) {
  const EcmParameters p;
  const EcmState start = deformed_body(p);
  const Reference ref(start, p);
  const auto advanced = [&](EcmState body, const EcmParameters& q) {
    SolidFields solid;
    follow_deformation(body, ref, solid);
    for (std::size_t i = 0; i < body.size(); ++i) body.x[i] += 0.05 * body.v[i];
    advance_stress(body, q, ref, solid, 0.05);
    return body;
  };
  const EcmState soft = advanced(start, p);
  const EcmState stiff = advanced(start, stiffer(p, 2.0));
  EcmState mixed = start;
  for (std::size_t i = 0; i < start.size(); ++i) mixed.E_ratio.push_back(i % 2 == 0 ? 1.0 : 2.0);
  mixed = advanced(mixed, p);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const EcmState& expected = i % 2 == 0 ? soft : stiff;
    EXPECT_LT((mixed.S[i] - expected.S[i]).norm(), 1e-13) << i;
    EXPECT_NEAR(mixed.rho[i], expected.rho[i], 1e-13) << i;
  }
}

TEST(GradedForces, OfTheFluidTakeTheModulusOfTheParticle) {
  const EcmParameters p;
  const auto half_fluid = [](EcmState body) {
    for (Vec2& x : body.x) x *= 0.7; // fluid under tension has no pressure
    for (std::size_t i = 0; i < body.size(); i += 2) body.f[i] = 0.0;
    return body;
  };
  EcmState ecm = half_fluid(deformed_body(p));
  const Adjacency pairs = neighbours_within(ecm.x, 2.0 * p.smoothing_length, 0.0);
  const auto fluid = [&](const EcmParameters& q) {
    std::vector<Vec2> force(ecm.size(), Vec2::Zero());
    std::vector<double> pressures;
    find_fluid_pressures(ecm, q, pairs, pressures);
    add_fluid_forces(ecm, q, pairs, pressures, force);
    return force;
  };
  const std::vector<Vec2> expected = fluid(stiffer(p, 3.0));
  EXPECT_GT(largest(expected), 0.0);
  ecm.E_ratio.assign(ecm.size(), 3.0);
  const std::vector<Vec2> graded = fluid(p);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    EXPECT_LT((graded[i] - expected[i]).norm(), 1e-13 * largest(expected)) << i;
  ecm = half_fluid(uneven_body(p));
  Vec2 sum = Vec2::Zero();
  for (const Vec2& f : fluid(p)) sum += f;
  EXPECT_LT(sum.norm(), 1e-12 * largest(expected));
}

TEST(FibreDirections, OfAConstantFieldGiveTheFibresOfAUniformMatrix) {
  const EcmParameters p;
  FibreParameters fibres;
  fibres.arrangement = FibreArrangement::uniaxial;
  fibres.direction_deg = 45.0;
  EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  const Reference ref(ecm, p);
  const FibreNetwork uniform_network(ecm, p, fibres, ref);
  ecm.fibre_direction.assign(ecm.size(), 0.25 * std::numbers::pi);
  fibres.direction_deg = 0.0; // not asked for
  const FibreNetwork network(ecm, p, fibres, ref);
  EXPECT_FALSE(network.empty());
  EXPECT_EQ(network.pairs().index, uniform_network.pairs().index);
  EXPECT_EQ(network.pairs().first, uniform_network.pairs().first);
}

TEST(FibreStiffness, IsTheMeanOfBothEnds) {
  const EcmParameters p;
  FibreParameters fibres;
  fibres.arrangement = FibreArrangement::isotropic;
  fibres.stiffness = 1.0;
  EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  const Reference ref(ecm, p);
  const FibreNetwork uniform(ecm, p, fibres, ref);
  for (const Vec2& X : ecm.X) ecm.fibre_ratio.push_back(X.x() < 0.0 ? 1.0 : 3.0);
  const FibreNetwork network(ecm, p, fibres, ref);
  for (Vec2& x : ecm.x) x *= 1.02; // all fibres are taut, below the onset
  double expected = 0.0;
  for (std::uint32_t i = 0; i < ecm.size(); ++i)
    for (std::uint32_t k = network.pairs().first[i]; k < network.pairs().first[i + 1]; ++k) {
      const double ratio = 0.5 * (ecm.fibre_ratio[i] + ecm.fibre_ratio[network.pairs().index[k]]);
      EXPECT_DOUBLE_EQ(network.weight(k), ratio * uniform.weight(k));
      expected += 0.5 * network.weight(k) * std::pow(network.length(k), 2) * fibre_energy(0.02, fibres);
    }
  EXPECT_NEAR(fibre_energy(ecm, fibres, network), expected, 1e-9 * expected);
}

TEST(FibreDirections, ThatVaryJoinBothParticlesOrNone) {
  const EcmParameters p;
  FibreParameters fibres;
  fibres.arrangement = FibreArrangement::uniaxial;
  EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  for (const Vec2& X : ecm.X) ecm.fibre_direction.push_back(std::atan2(X.y(), X.x())); // radial
  const Reference ref(ecm, p);
  const FibreNetwork network(ecm, p, fibres, ref);
  for (std::uint32_t i = 0; i < ecm.size(); ++i)
    for (const std::uint32_t j : network.pairs().of(i)) {
      EXPECT_EQ(std::ranges::count(network.pairs().of(j), i), 1);
      const Vec2 X = ecm.X[i] - ecm.X[j];
      const Vec2 radial = ecm.X[i] + ecm.X[j];
      if (radial.norm() > 20.0) {
        EXPECT_GT(std::abs(X.dot(radial)), 0.8 * X.norm() * radial.norm());
      }
    }
}

TEST(FibreDirections, OfAPairAreTheMeanOfTwoAxes) {
  EcmState ecm;
  const double degree = std::numbers::pi / 180.0;
  ecm.fibre_direction = {10.0 * degree, 30.0 * degree, 175.0 * degree};
  EXPECT_NEAR(fibre_direction(ecm, {}, 0, 1), 20.0 * degree, 1e-12);
  EXPECT_NEAR(std::remainder(fibre_direction(ecm, {}, 0, 2) - 2.5 * degree, std::numbers::pi), 0.0, 1e-12);
  EXPECT_EQ(fibre_direction(ecm, {}, 1, 2), fibre_direction(ecm, {}, 2, 1));
}
