#include "ecm/degradation.hpp"

#include "body.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(Degraded, FallsLinearlyAndNeverBelowZero) {
  EXPECT_DOUBLE_EQ(degraded(1.0, 0.2, 0.4), 0.92);
  EXPECT_EQ(degraded(0.05, 0.2, 0.4), 0.0);
  EXPECT_EQ(degraded(0.3, 0.0, 0.4), 0.3);
  double f = 1.0;
  int steps = 0;
  for (; f > 0.0; ++steps) f = degraded(f, 0.2, 0.4); // 5 s at the tip
  EXPECT_NEAR(steps * 0.4, 5.0, 0.41);
}

TEST(Torn, WhatReachesABoundOfDensityBecomesFluid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 20.0, 20.0, 2.0);
  EXPECT_EQ(fluidize_torn(ecm, p), 0U);
  ecm.rho[44] = p.density_min;
  ecm.rho[45] = p.density_max;
  ecm.rho[46] = 1.79;
  ecm.rho[0] = p.density_max; // clamped
  EXPECT_EQ(fluidize_torn(ecm, p), 2U);
  EXPECT_EQ(ecm.f[44], 0.0);
  EXPECT_EQ(ecm.f[45], 0.0);
  EXPECT_EQ(ecm.rho[45], 1.0);
  EXPECT_EQ(ecm.f[46], 1.0);
  EXPECT_EQ(ecm.f[0], 1.0);
  EXPECT_EQ(fluidize_torn(ecm, p), 0U);
}

TEST(Orphans, AFlakeWithoutSupportBecomesFluid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  Reference ref(ecm, p);
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U); // intact, corners included
  const std::size_t flake = 10 * 20 + 10;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const double r = (ecm.X[i] - ecm.X[flake]).norm();
    if (r > 0.0 && r < 8.0) ecm.f[i] = 0.0;
  }
  ecm.S[flake](0, 1) = 0.01;
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 1U);
  EXPECT_EQ(ecm.f[flake], 0.0);
  EXPECT_EQ(ecm.S[flake].norm(), 0.0);
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U);
}

TEST(Orphans, AChainUnravelsToItsEnd) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (i / 20 != 10) ecm.f[i] = 0.0; // a single row is left: no support across it
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 20U);
  for (const double f : ecm.f) EXPECT_EQ(f, 0.0);
}

TEST(Orphans, ClampedParticlesStaySolid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  ecm.clamped[0] = 1;
  Reference ref(ecm, p);
  for (std::size_t i = 1; i < ecm.size(); ++i) ecm.f[i] = 0.0;
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U);
  EXPECT_EQ(ecm.f[0], 1.0);
}
