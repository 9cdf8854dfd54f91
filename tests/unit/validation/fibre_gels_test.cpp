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
    EXPECT_NEAR(semi_affine_stress(strain, 0.075, 0.033), stress, 0.002 * stress) << strain;
}

TEST(AffineLattice, WithoutFibresIsTheElasticRestInPlaneStrain) {
  Parameters p;
  p.fibres.stiffness = 0.0;
  const std::vector<Stretch> curve = affine_lattice(p, 1e-3, 1);
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
