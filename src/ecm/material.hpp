#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

/// Laws of the intact matrix at a point: isotropic elasticity in rate form, plane strain. Pure functions. Each is
/// written once, over the components of its tensors: loops over particles, which the compiler vectorizes, call the same
/// functions as code for a single particle, and get the same bits.
/// Test: tests/unit/ecm/material_test.cpp, tests/unit/ecm/stress_test.cpp
namespace matrigrate {

/// A tensor of the plane by its components.
struct Tensor {
  double xx, xy, yx, yy;

  static Tensor of(const Mat2& A) { return {A(0, 0), A(0, 1), A(1, 0), A(1, 1)}; }
  Mat2 matrix() const { return (Mat2() << xx, xy, yx, yy).finished(); }
};

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
[[gnu::always_inline]] inline double density_rate(double rho, const Tensor& L) { return -rho * (L.xx + L.yy); }
inline double density_rate(double rho, const Mat2& L) { return density_rate(rho, Tensor::of(L)); }

/// Rate of the deviatoric stress, Jaumann rate of Hooke's law: 2 G (D - tr D/3 I) + W S - S W, with D and W the
/// symmetric and skew parts of L. A rotation turns the stress and makes none.
/// @param S  deviatoric stress, in-plane part [kPa]   @param L  velocity gradient [1/s]   @return [kPa/s]
[[gnu::always_inline]] inline Tensor jaumann_rate(const Tensor& S, const Tensor& L, double G) {
  const double mean = (L.xx + L.yy) / 3.0;
  const double turn = 0.5 * (L.xy - L.yx); // W_xy
  const double shear = G * (L.xy + L.yx) + turn * (S.yy - S.xx);
  return {2.0 * G * (L.xx - mean) + turn * (S.yx + S.xy), shear, shear, 2.0 * G * (L.yy - mean) - turn * (S.yx + S.xy)};
}
inline Mat2 jaumann_rate(const Mat2& S, const Mat2& L, double G) {
  return jaumann_rate(Tensor::of(S), Tensor::of(L), G).matrix();
}

/// Cauchy stress, sigma = -p I + S, in-plane part [kPa].
[[gnu::always_inline]] inline Tensor cauchy_stress(double rho, const Tensor& S, double K) {
  const double p = pressure(rho, K);
  return {S.xx - p, S.xy, S.yx, S.yy - p};
}
inline Mat2 cauchy_stress(double rho, const Mat2& S, double K) { return cauchy_stress(rho, Tensor::of(S), K).matrix(); }

/// First Piola-Kirchhoff stress P = J sigma F^-T [kPa].
/// @param F  deformation gradient [-]
[[gnu::always_inline]] inline Tensor piola_kirchhoff(const Tensor& sigma, const Tensor& F) {
  return {sigma.xx * F.yy - sigma.xy * F.xy, sigma.xy * F.xx - sigma.xx * F.yx, sigma.yx * F.yy - sigma.yy * F.xy,
          sigma.yy * F.xx - sigma.yx * F.yx};
}
inline Mat2 piola_kirchhoff(const Mat2& sigma, const Mat2& F) {
  return piola_kirchhoff(Tensor::of(sigma), Tensor::of(F)).matrix();
}

/// Velocity gradient L = dF/dt F^-1 [1/s].
/// @param rate  dF/dt [1/s]   @param F  deformation gradient, det F > 0 [-]
[[gnu::always_inline]] inline Tensor velocity_gradient(const Tensor& rate, const Tensor& F) {
  const double per_J = 1.0 / (F.xx * F.yy - F.xy * F.yx);
  return {per_J * (rate.xx * F.yy - rate.xy * F.yx), per_J * (rate.xy * F.xx - rate.xx * F.xy),
          per_J * (rate.yx * F.yy - rate.yy * F.yx), per_J * (rate.yy * F.xx - rate.yx * F.xy)};
}
inline Mat2 velocity_gradient(const Mat2& rate, const Mat2& F) {
  return velocity_gradient(Tensor::of(rate), Tensor::of(F)).matrix();
}

/// Von Mises stress of the plane-strain state with S_zz = -(S_xx + S_yy) [kPa].
double von_mises(const Mat2& S);

} // namespace matrigrate
