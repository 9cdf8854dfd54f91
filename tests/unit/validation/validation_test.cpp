#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/fibre_gels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace matrigrate;
using namespace matrigrate::validation;

namespace {

const double G = 0.069, nu = 0.45, a = 50.0;
Vec2 u(const Vec2& x) { return clamped_disc_displacement(Vec2(0.06, 0.0), x, a, G, nu); }

/// Gradient of u by central differences.
Mat2 gradient(const Vec2& x) {
  const double d = 1e-4;
  Mat2 H;
  for (int c = 0; c < 2; ++c) H.col(c) = (u(x + d * Vec2::Unit(c)) - u(x - d * Vec2::Unit(c))) / (2.0 * d);
  return H;
}

Mat2 stress(const Vec2& x) {
  const Mat2 e = 0.5 * (gradient(x) + gradient(x).transpose());
  return 2.0 * G * e + 2.0 * G * nu / (1.0 - 2.0 * nu) * e.trace() * Mat2::Identity();
}

} // namespace

TEST(ClampedDisc, StandsStillOnItsRim) {
  for (const double angle : {0.0, 0.7, 1.5, 3.0})
    EXPECT_NEAR(u(a * Vec2(std::cos(angle), std::sin(angle))).norm(), 0.0, 1e-14);
}

TEST(ClampedDisc, IsInEquilibriumInside) {
  const double d = 0.05;
  for (const Vec2& x : {Vec2(10.0, 5.0), Vec2(-20.0, 12.0), Vec2(3.0, -30.0)}) {
    const Vec2 divergence = (stress(x + Vec2(d, 0.0)).col(0) - stress(x - Vec2(d, 0.0)).col(0)
                             + stress(x + Vec2(0.0, d)).col(1) - stress(x - Vec2(0.0, d)).col(1))
                            / (2.0 * d);
    EXPECT_NEAR(divergence.norm(), 0.0, 1e-3 * stress(x).norm() / x.norm());
  }
}

TEST(ClampedDisc, CarriesTheWholeForceAcrossEveryCircle) {
  for (const double r : {5.0, 20.0, 40.0}) {
    Vec2 traction = Vec2::Zero();
    const int n = 720;
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / n;
      const Vec2 e_r(std::cos(angle), std::sin(angle));
      traction += stress(r * e_r) * e_r * (2.0 * std::numbers::pi * r / n);
    }
    EXPECT_NEAR((traction - Vec2(-0.06, 0.0)).norm(), 0.0, 1e-6);
  }
}

TEST(LatticeViscosity, IsSlightlyBelowTheNominalOne) {
  const double mu = lattice_viscosity(EcmParameters{});
  EXPECT_GT(mu, 0.94);
  EXPECT_LT(mu, 1.0);
}

TEST(Fits, FindWhatWasPutIn) {
  std::vector<double> t, y, line;
  for (int k = 0; k <= 100; ++k) {
    t.push_back(0.5 * k);
    y.push_back(3.0 - 2.0 * std::exp(-t.back() / 7.0));
    line.push_back(4.0 - 0.25 * t.back());
  }
  EXPECT_NEAR(fit_time_constant(t, y, 3.0), 7.0, 1e-9);
  EXPECT_NEAR(fit_slope(t, line), -0.25, 1e-12);
}

TEST(Check, HoldsWithinItsToleranceAndNotForNan) {
  EXPECT_TRUE((Check{"", 1.04, 1.0, 0.05, ""}.holds()));
  EXPECT_FALSE((Check{"", 1.06, 1.0, 0.05, ""}.holds()));
  EXPECT_FALSE((Check{"", std::nan(""), 1.0, 0.05, ""}.holds()));
  EXPECT_TRUE((Check{"", 5.0, 2.0, 0.0, "", Sense::at_least}.holds()));
  EXPECT_FALSE((Check{"", 1.9, 2.0, 0.0, "", Sense::at_least}.holds()));
  EXPECT_FALSE(Result{}.holds());
}

// Against finite elements: quadratic triangles, plane strain, converged to 4e-5.
TEST(ClampedDisc, HasTheComplianceOfFiniteElementsUnderALoadSpreadOverAKernel) {
  const double E = 0.2;
  EXPECT_NEAR(clamped_disc_compliance(Kernel(2.6), 150.0 - 2.0 * 2.6 + 1.0, E / (2.0 * (1.0 + nu)), nu), 4.479, 0.01);
}

// Nominal stress over k_0 from an independent evaluation of the law, eps_s = 0.075, d_s = 0.033.
TEST(SemiAffineLaw, HasTheValuesOfAnIndependentEvaluation) {
  for (const auto& [strain, stress] : {std::pair{0.02, 0.00219}, std::pair{0.06, 0.00455}, std::pair{0.10, 0.00687},
                                       std::pair{0.14, 0.01168}, std::pair{0.20, 0.0441}})
    EXPECT_NEAR(semi_affine_stress(strain, 0.075, 0.033, Sides::free), stress, 0.002 * stress) << strain;
}

// Fibres at small strain: tension only, so all of them pull along x; <c^4> = 1/5 over directions in space.
TEST(SemiAffineLaw, HasAFifthOfItsFibresStiffnessWithHeldSides) {
  EXPECT_NEAR(semi_affine_stress(1e-4, 0.075, 0.033, Sides::held), 0.2e-4, 0.001 * 0.2e-4);
  for (const double strain : {0.02, 0.06, 0.10})
    EXPECT_GT(semi_affine_stress(strain, 0.075, 0.033, Sides::held),
              semi_affine_stress(strain, 0.075, 0.033, Sides::free));
}

TEST(AffineLattice, WithHeldSidesIsConfinedWithoutFibres) {
  Parameters p;
  p.fibres.stiffness = 0.0;
  const std::vector<Stretch> curve = affine_lattice(p, 1e-3, 1, Sides::held);
  const double poisson = p.ecm.poissons_ratio;
  const double confined = p.ecm.youngs_modulus * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  EXPECT_NEAR(curve[0].stress, confined * 1e-3, 0.002 * curve[0].stress);
  EXPECT_EQ(curve[0].lateral_strain, 0.0);
}

TEST(PullStrip, IsTheInfiniteLatticeWithHeldSides) {
  Parameters p;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  for (const double direction : {0.0, 90.0}) { // from the pull
    p.fibres.direction_deg = direction;
    const std::vector<Stretch> strip = pull_strip(p, 0.02, 2);
    const std::vector<Stretch> lattice = affine_lattice(p, 0.021, 21, Sides::held);
    EXPECT_NEAR(strip[1].strain, 0.02, 2e-5); // solver.tolerance
    EXPECT_NEAR(strip[1].stress, stress_at(lattice, 0.02), 0.01 * strip[1].stress) << direction;
  }
}

TEST(AffineLattice, WithoutFibresIsTheElasticRestInPlaneStrain) {
  Parameters p;
  p.fibres.stiffness = 0.0;
  const std::vector<Stretch> curve = affine_lattice(p, 1e-3, 1, Sides::free);
  const double poisson = p.ecm.poissons_ratio;
  EXPECT_NEAR(curve[0].stress, p.ecm.youngs_modulus / (1.0 - poisson * poisson) * 1e-3, 0.01 * curve[0].stress);
  EXPECT_NEAR(curve[0].lateral_strain, -poisson / (1.0 - poisson) * 1e-3, 1e-5);
}

TEST(StressAt, InterpolatesFromTheOriginAndEndsWithTheCurve) {
  const std::vector<Stretch> curve{{0.1, 0.0, 2.0}, {0.2, 0.0, 6.0}};
  EXPECT_DOUBLE_EQ(stress_at(curve, 0.05), 1.0);
  EXPECT_DOUBLE_EQ(stress_at(curve, 0.15), 4.0);
  EXPECT_TRUE(std::isnan(stress_at(curve, 0.3)));
}
