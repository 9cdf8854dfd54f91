#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

/// Laws of the intact matrix at a point: isotropic elasticity in rate form, plane strain. Pure functions.
/// Test: tests/unit/ecm/material_test.cpp
namespace matrigrate {

/// Moduli that follow from E and nu [kPa].
struct Moduli {
  double K; ///< bulk modulus, E / (3 (1 - 2 nu))
  double G; ///< shear modulus, E / (2 (1 + nu))

  double longitudinal() const { return K + 4.0 / 3.0 * G; } ///< stiffness against confined compression
};

Moduli moduli(const EcmParameters& ecm);

/// Hydrostatic pressure, equation of state of the solid: p = K (rho/rho_0 - 1) [kPa].
/// @param rho  density over rho_0 [-], > 0
inline double pressure(double rho, double K) { return K * (rho - 1.0); }

/// Rate of density, continuity equation: d(rho)/dt = -rho tr L [1/s].
/// @param L  velocity gradient [1/s]
inline double density_rate(double rho, const Mat2& L) { return -rho * L.trace(); }

/// Rate of the deviatoric stress, Jaumann rate of Hooke's law: 2 G (D - tr D/3 I) + W S - S W, with D and W the
/// symmetric and skew parts of L. A rotation turns the stress and makes none.
/// @param S  deviatoric stress, in-plane part [kPa]   @param L  velocity gradient [1/s]   @return [kPa/s]
inline Mat2 jaumann_rate(const Mat2& S, const Mat2& L, double G) {
  const double mean = (L(0, 0) + L(1, 1)) / 3.0;
  const double turn = 0.5 * (L(0, 1) - L(1, 0)); // W_xy
  Mat2 rate;
  rate(0, 0) = 2.0 * G * (L(0, 0) - mean) + turn * (S(1, 0) + S(0, 1));
  rate(1, 1) = 2.0 * G * (L(1, 1) - mean) - turn * (S(1, 0) + S(0, 1));
  rate(0, 1) = rate(1, 0) = G * (L(0, 1) + L(1, 0)) + turn * (S(1, 1) - S(0, 0));
  return rate;
}

/// Cauchy stress, sigma = -p I + S, in-plane part [kPa].
inline Mat2 cauchy_stress(double rho, const Mat2& S, double K) { return S - pressure(rho, K) * Mat2::Identity(); }

/// Von Mises stress of the plane-strain state with S_zz = -(S_xx + S_yy) [kPa].
double von_mises(const Mat2& S);

} // namespace matrigrate
