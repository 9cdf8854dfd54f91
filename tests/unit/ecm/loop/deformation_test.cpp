#include "ecm/loop/deformation.hpp"

#include "unit/ecm/body.hpp"

#include <gtest/gtest.h>

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
