#include "ecm/loop/stress.hpp"

#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "unit/ecm/body.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

using namespace matrigrate;

namespace {

struct Forces {
  SolidFields solid;
  std::vector<Vec2> force;
};

Forces forces_of(const EcmState& ecm, const EcmParameters& p, const Reference& ref) {
  Forces a;
  a.force.assign(ecm.size(), Vec2::Zero());
  add_elastic_forces(ecm, p, ref, a.solid, a.force);
  return a;
}

std::vector<Mat2> gradients(const EcmState& ecm, const Reference& ref) {
  std::vector<Mat2> F(ecm.size(), Mat2::Identity());
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.f[i] > 0.0) F[i] = deformation_gradient(ecm, ref, i);
  return F;
}

} // namespace

TEST(ElasticForces, VanishAtRest) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  const Reference ref(ecm, p);
  for (const Vec2& f : forces_of(ecm, p, ref).force) EXPECT_EQ(f.norm(), 0.0);
}

TEST(ElasticForces, HaveNoNetForceAndNoTorque) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const Forces a = forces_of(ecm, p, ref);
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, magnitude = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    sum += a.force[i];
    torque += cross(ecm.x[i], a.force[i]);
    magnitude += a.force[i].norm();
    moment += ecm.x[i].norm() * a.force[i].norm();
  }
  EXPECT_GT(magnitude, 0.1);
  EXPECT_LT(sum.norm(), 1e-14 * magnitude);
  EXPECT_LT(std::abs(torque), 1e-13 * moment);
}

TEST(ElasticForces, WorkAgainstTheRateOfDeformation) { // power balance: the force is the adjoint of the gradient
  EcmParameters p;
  p.hourglass_weight = 0.0;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const Forces a = forces_of(ecm, p, ref);
  double force_power = 0.0, stress_power = 0.0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    force_power += a.force[i].dot(ecm.v[i]);
    if (ecm.f[i] <= 0.0) continue;
    const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], moduli(p).K), a.solid.F(ecm, i));
    stress_power += p.thickness * ecm.V0 * ecm.f[i] * contraction(P, deformation_rate(ecm, ref, i));
  }
  EXPECT_GT(std::abs(stress_power), 1e-3);
  EXPECT_NEAR(force_power, -stress_power, 1e-13);
}

TEST(ElasticForces, TurnWithTheBody) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const Forces before = forces_of(ecm, p, ref);
  const Mat2 R = Eigen::Rotation2Dd(0.8).toRotationMatrix();
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.x[i] = R * ecm.x[i] + Vec2(5.0, -2.0);
    ecm.S[i] = R * ecm.S[i] * R.transpose();
  }
  const Forces after = forces_of(ecm, p, ref);
  for (std::size_t i = 0; i < ecm.size(); ++i) EXPECT_NEAR((after.force[i] - R * before.force[i]).norm(), 0.0, 1e-14);
}

TEST(HourglassForces, AreTheGradientOfTheirEnergy) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  std::fill(ecm.S.begin(), ecm.S.end(), Mat2::Zero());
  std::fill(ecm.rho.begin(), ecm.rho.end(), 1.0); // no stress: only the penalty acts
  const Reference ref(ecm, p);
  const Forces a = forces_of(ecm, p, ref);
  const double d = 1e-4;
  double largest = 0.0;
  for (const std::size_t i : {0UL, 17UL, 60UL, 111UL, 140UL})
    for (int c = 0; c < 2; ++c) {
      EcmState moved = ecm;
      moved.x[i](c) += d;
      const double up = hourglass_energy(moved, p, ref, gradients(moved, ref));
      moved.x[i](c) -= 2.0 * d;
      const double down = hourglass_energy(moved, p, ref, gradients(moved, ref));
      EXPECT_NEAR(a.force[i](c), -p.thickness * (up - down) / (2.0 * d), 1e-11);
      largest = std::max(largest, std::abs(a.force[i](c)));
    }
  EXPECT_GT(largest, 1e-6);
}

TEST(HourglassForces, ResistACheckerboardThatTheGradientDoesNotSee) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] += ((i / 20 + i % 20) % 2 == 0 ? 0.01 : -0.01) * Vec2(1.0, 0.0);
  const std::size_t middle = 10 * 20 + 10;
  EXPECT_NEAR((deformation_gradient(ecm, ref, middle) - Mat2::Identity()).norm(), 0.0, 1e-12);
  const double back = forces_of(ecm, p, ref).force[middle].x() * (ecm.x[middle] - ecm.X[middle]).x();
  EXPECT_LT(back, -1e-6);
}

TEST(StressUpdate, HoldsAndCountsTheBoundsOfDensity) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  const Reference ref(ecm, p);
  SolidFields solid = undeformed(ecm.size());
  const auto implode = [&](double share) {
    for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] = (1.0 - share) * ecm.X[i];
  };
  implode(0.05);
  EXPECT_EQ(advance_stress(ecm, p, ref, solid, 0.1).above, 0U);
  EXPECT_NEAR(ecm.rho[0], 1.1, 1e-12);
  implode(0.9);
  EXPECT_EQ(advance_stress(ecm, p, ref, solid, 2.0).above, ecm.size());
  EXPECT_EQ(ecm.rho[0], p.density_max);
}

namespace {

void expect_same(const SolidFields& a, const SolidFields& b, const EcmState& ecm) {
  EXPECT_EQ(a.f, b.f);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(a.fu[i], b.fu[i]);
    EXPECT_EQ(a.H[i], b.H[i]);
    EXPECT_EQ(a.F(ecm, i), b.F(ecm, i));
  }
}

} // namespace

TEST(Deformation, FollowedHereAndThereHasTheSameBitsAsIfAllWereComputed) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  Reference ref(ecm, p);
  SolidFields kept;
  for (std::size_t step = 0; step < 5; ++step) {
    follow_deformation(ecm, ref, kept);
    SolidFields anew;
    follow_deformation(ecm, ref, anew);
    expect_same(kept, anew, ecm);
    for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] += 0.01 * ecm.v[i];
    advance_stress(ecm, p, ref, kept, 0.01);
    SolidFields after;
    follow_deformation(ecm, ref, after);
    expect_same(kept, after, ecm);
    ecm.f[37 + 5 * step] *= 0.5; // what happens between steps
    ecm.f[101 + step] = 0.0;
    ecm.x[150 - step] += Vec2(0.1, -0.2);
    ref.update(ecm);
  }
}

// The loops over rows of particles against the laws of material.hpp, bit by bit.
TEST(StressUpdate, OfIntactParticlesIsTheLawOfOneParticle) {
  EcmParameters p;
  p.density_max = 1.08; // some particles lie above
  EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  SolidFields solid;
  follow_deformation(ecm, ref, solid);
  const SolidFields before = solid;
  const EcmState start = ecm;
  const double dt = 0.05;
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] += dt * ecm.v[i];
  const DensityBounds bounds = advance_stress(ecm, p, ref, solid, dt);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] < 1.0) continue;
    const Mat2 rate = (1.0 / dt) * (solid.H[i] - before.H[i]);
    const Mat2 L = velocity_gradient(rate, Mat2::Identity() + before.H[i]);
    const double rho = start.rho[i] + dt * density_rate(start.rho[i], L);
    EXPECT_EQ(ecm.rho[i], std::clamp(rho, p.density_min, p.density_max)) << i;
    const Mat2 S = start.S[i] + dt * jaumann_rate(start.S[i], L, moduli(p).G);
    EXPECT_EQ(ecm.S[i], S) << i;
    ++compared;
  }
  EXPECT_GT(compared, 100U);
  EXPECT_GT(bounds.above, 0U);
}

TEST(ElasticForces, OfIntactParticlesTakeTheLawOfOneParticle) {
  EcmParameters p;
  p.hourglass_weight = 0.0;
  const EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const SolidFields solid = forces_of(ecm, p, ref).solid;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (!ref.plain(ecm, i)) continue;
    const Mat2 P = piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], moduli(p).K), solid.F(ecm, i));
    EXPECT_EQ(solid.PB[i], Mat2(ref.lattice_correction() * P)) << i;
    ++compared;
  }
  EXPECT_GT(compared, 5U);
}

TEST(StressUpdate, LeavesFluidAlone) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const Reference ref(ecm, p);
  const EcmState before = ecm;
  SolidFields solid = forces_of(ecm, p, ref).solid;
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.x[i] += 0.1 * ecm.v[i];
  advance_stress(ecm, p, ref, solid, 0.1);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(ecm.f[i] == 0.0, ecm.S[i] == before.S[i]);
  }
}
