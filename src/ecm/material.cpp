#include "ecm/material.hpp"

#include <cmath>

namespace matrigrate {

Moduli moduli(const EcmParameters& ecm) {
  const double E = ecm.youngs_modulus;
  const double nu = ecm.poissons_ratio;
  return {.K = E / (3.0 * (1.0 - 2.0 * nu)), .G = E / (2.0 * (1.0 + nu))};
}

double von_mises(const Mat2& S) {
  const double S_zz = -S.trace();
  return std::sqrt(1.5 * (S.squaredNorm() + S_zz * S_zz));
}

} // namespace matrigrate
