#include "validation/fibre_gels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

using namespace matrigrate;
using namespace matrigrate::validation;

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
  const double nu = p.ecm.poissons_ratio;
  const double confined = p.ecm.youngs_modulus * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
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
  const double nu = p.ecm.poissons_ratio;
  EXPECT_NEAR(curve[0].stress, p.ecm.youngs_modulus / (1.0 - nu * nu) * 1e-3, 0.01 * curve[0].stress);
  EXPECT_NEAR(curve[0].lateral_strain, -nu / (1.0 - nu) * 1e-3, 1e-5);
}

TEST(StressAt, InterpolatesFromTheOriginAndEndsWithTheCurve) {
  const std::vector<Stretch> curve{{0.1, 0.0, 2.0}, {0.2, 0.0, 6.0}};
  EXPECT_DOUBLE_EQ(stress_at(curve, 0.05), 1.0);
  EXPECT_DOUBLE_EQ(stress_at(curve, 0.15), 4.0);
  EXPECT_TRUE(std::isnan(stress_at(curve, 0.3)));
}
