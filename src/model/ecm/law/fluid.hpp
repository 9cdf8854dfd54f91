#pragma once

#include "ecm/law/material.hpp"

#include <algorithm>

namespace matrigrate {

/// Pressure of a fluid or partly fluid particle: (1 - f) K max(0, rho - 1) [kPa]. It resists compression and not
/// tension (MODEL.md, I6). Test: tests/unit/ecm/loop/loop_test.cpp
/// @param f  f_degr, 1 intact, 0 fluid [-]   @param rho  summed density over that of the lattice [-]
template <class Real>
[[gnu::always_inline]] inline Real fluid_pressure(const Real& f, const Real& rho, double K) {
  using std::max;
  return (1.0 - f) * max(Real(0.0), pressure(rho, K));
}

} // namespace matrigrate
