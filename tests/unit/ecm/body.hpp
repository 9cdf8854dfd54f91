#pragma once

#include "ecm/reference.hpp"
#include "state/initial.hpp"

#include <cmath>

/// A free body in an arbitrary smooth deformation, partly degraded; a fixture of several tests.
namespace matrigrate {

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

} // namespace matrigrate
