#include "ecm/reference.hpp"

#include "body.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(Reference, SupportInsideALatticeIsNearlyTheIdentity) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.X[i].cwiseAbs().maxCoeff() > 14.0) continue;
    EXPECT_NEAR((ref.B(i) - Mat2::Identity()).norm(), 0.0, 0.05);
    EXPECT_NEAR(ref.B(i)(0, 1), 0.0, 1e-14);
  }
}

TEST(Reference, ABodysOwnEdgeIsNoDamage) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) EXPECT_GE(ref.relative_support(i), 1.0 - 1e-12);
}

TEST(Reference, AnUpdateEqualsAFreshStart) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 30.0, 30.0, 0.0);
  Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); i += 3) ecm.f[i] = 0.4;
  ecm.f[100] = 0.0;
  ref.update(ecm);
  const Reference fresh(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(ref.B(i), fresh.B(i));
    EXPECT_EQ(ref.relative_support(i), fresh.relative_support(i));
  }
}

TEST(Reference, LostSupportIsSeenAndItsInverseBounded) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 30.0, 30.0, 0.0);
  const std::size_t flake = 7 * 15 + 7;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (i != flake && i != flake + 1) ecm.f[i] = 0.0; // one partner left: no support across
  const Reference ref(ecm, p);
  EXPECT_LT(ref.relative_support(flake), 0.01);
  EXPECT_LE(ref.B(flake).norm(), 1.5 / p.support_floor);
}

TEST(Reference, AClampGoesOnBeyondItsLastRow) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 20.0, 5.2);
  const Reference ref(ecm, p);
  std::size_t clamped = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) {
      ++clamped;
      EXPECT_NEAR((ref.B(i) - ref.B(i)(0, 0) * Mat2::Identity()).norm(), 0.0, 1e-12);
      EXPECT_NEAR(ref.B(i)(0, 0), 1.0, 0.05);
    }
  EXPECT_GT(clamped, 0U);
}
