#include "observe/fields.hpp"

#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

TEST(Fields, OfAStretchedGelWithAHoleOfFluid) {
  const EcmParameters p;
  FibreParameters fibres;
  fibres.arrangement = FibreArrangement::isotropic;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const FibreNetwork network(ecm, p, fibres, Reference(ecm, p));
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.x[i].x() *= 1.05;
    if (ecm.X[i].norm() < 6.0) ecm.f[i] = 0.0;
  }
  const std::vector<double> u = displacement_field(ecm);
  const std::vector<double> stress = fibre_stress_field(ecm, fibres, network);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(std::isnan(u[i]), ecm.f[i] == 0.0);
    EXPECT_EQ(std::isnan(stress[i]), ecm.f[i] == 0.0);
    if (ecm.f[i] > 0.0) {
      EXPECT_NEAR(u[i], 0.05 * std::abs(ecm.X[i].x()), 1e-12);
      EXPECT_GT(stress[i], 1e-3);
    }
  }
  EXPECT_TRUE(std::isnan(fibre_stress_field(ecm, fibres, FibreNetwork()).front()));
}
