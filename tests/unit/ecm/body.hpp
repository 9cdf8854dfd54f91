#pragma once

#include "ecm/reference.hpp"
#include "solve/drag_system.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace matrigrate {

/// A free body in an arbitrary smooth deformation, partly degraded; a fixture of several tests.
inline EcmState deformed_body(const EcmParameters& p) {
  EcmState ecm = rectangle(p, 30.0, 24.0, 0.0);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const Vec2& X = ecm.X[i];
    ecm.x[i] = X + Vec2(0.6 * std::sin(0.3 * X.y()) + 0.1 * X.x(), 0.5 * std::cos(0.2 * X.x() + 0.1 * X.y()));
    ecm.v[i] = Vec2(std::sin(0.5 * X.x()), std::cos(0.4 * X.y() - X.x()));
    ecm.S[i] << 0.01 * std::sin(X.x()), 0.02 * std::cos(X.y()), 0.02 * std::cos(X.y()), -0.01;
    ecm.rho[i] = 1.0 + 0.1 * std::sin(X.x() + X.y());
    if (X.x() > 6.0) ecm.f[i] = 0.6;
    if (X.norm() < 4.0) ecm.f[i] = 0.0;
  }
  return ecm;
}

/// The drag of the matrix, coefficient by coefficient.
inline void expect_same(const DragSystem& a, const DragSystem& b) {
  EXPECT_EQ(a.diagonal, b.diagonal);
  EXPECT_EQ(a.prescribed, b.prescribed);
  EXPECT_EQ(a.F, b.F);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::pair<std::size_t, float>> of_a, of_b;
    a.pairs.each_of_row(i, [&](std::size_t j, float G) { of_a.emplace_back(j, G); });
    b.pairs.each_of_row(i, [&](std::size_t j, float G) { of_b.emplace_back(j, G); });
    EXPECT_EQ(of_a, of_b) << "row " << i;
  }
}

} // namespace matrigrate
