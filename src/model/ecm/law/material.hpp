#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

/// Components of a tensor of the plane, for any number type; the argument type of the laws.
template <class Real>
struct TensorOf {
  Real xx, xy, yx, yy;
};

using Tensor = TensorOf<double>;

inline Tensor components(const Mat2& A) { return {A(0, 0), A(0, 1), A(1, 0), A(1, 1)}; }
inline Mat2 matrix(const Tensor& A) { return (Mat2() << A.xx, A.xy, A.yx, A.yy).finished(); }

// Laws of the intact matrix at a point: isotropic elasticity in rate form, plane strain. Pure functions, templates
// over the number type: vectorised loops over particles and code for a single particle call the same functions and get
// the same bits. Test: tests/unit/ecm/law/law_test.cpp, tests/unit/ecm/loop/stress_test.cpp

/// Moduli that follow from E and nu [kPa].
struct Moduli {
  double K; ///< bulk modulus, E / (3 (1 - 2 nu))
  double G; ///< shear modulus, E / (2 (1 + nu))

  double longitudinal() const { return K + 4.0 / 3.0 * G; } ///< stiffness against confined compression
};

inline Moduli moduli(const EcmParameters& ecm) {
  const double E = ecm.youngs_modulus;
  const double nu = ecm.poissons_ratio;
  return {.K = E / (3.0 * (1.0 - 2.0 * nu)), .G = E / (2.0 * (1.0 + nu))};
}

/// Hydrostatic pressure, equation of state of the solid: p = K (rho/rho_0 - 1) [kPa].
/// @param rho  density over rho_0 [-], > 0
template <class Real>
[[gnu::always_inline]] inline Real pressure(const Real& rho, double K) {
  return K * (rho - 1.0);
}

/// Rate of density, continuity equation: d(rho)/dt = -rho tr L [1/s].
/// @param L  velocity gradient [1/s]
template <class Real>
[[gnu::always_inline]] inline Real density_rate(const Real& rho, const TensorOf<Real>& L) {
  return -rho * (L.xx + L.yy);
}
inline double density_rate(double rho, const Mat2& L) { return density_rate(rho, components(L)); }

/// Rate of the deviatoric stress, Jaumann rate of Hooke's law: 2 G (D - tr D/3 I) + W S - S W, with D and W the
/// symmetric and skew parts of L. Objective: a rigid rotation turns the stress and creates none.
/// @param S  deviatoric stress, in-plane part [kPa]   @param L  velocity gradient [1/s]   @return [kPa/s]
template <class Real>
[[gnu::always_inline]] inline TensorOf<Real> jaumann_rate(const TensorOf<Real>& S, const TensorOf<Real>& L, double G) {
  const Real mean = (L.xx + L.yy) / 3.0;
  const Real turn = 0.5 * (L.xy - L.yx); // W_xy
  const Real shear = G * (L.xy + L.yx) + turn * (S.yy - S.xx);
  return {2.0 * G * (L.xx - mean) + turn * (S.yx + S.xy), shear, shear, 2.0 * G * (L.yy - mean) - turn * (S.yx + S.xy)};
}
inline Mat2 jaumann_rate(const Mat2& S, const Mat2& L, double G) {
  return matrix(jaumann_rate(components(S), components(L), G));
}

/// Density [-] and deviatoric stress [kPa] of a particle.
template <class Real>
struct SolidStateOf {
  Real rho;
  TensorOf<Real> S;
};

/// Density and stress after a step of dt [s] under the velocity gradient L [1/s], explicit Euler; the density is
/// limited to its bounds.
template <class Real>
[[gnu::always_inline]] inline SolidStateOf<Real> advanced(const SolidStateOf<Real>& old, const TensorOf<Real>& L,
                                                          double G, double dt, double density_min, double density_max) {
  using std::max, std::min;
  const Real rho = old.rho + dt * density_rate(old.rho, L);
  const TensorOf<Real> change = jaumann_rate(old.S, L, G);
  return {min(max(rho, Real(density_min)), Real(density_max)),
          {old.S.xx + dt * change.xx, old.S.xy + dt * change.xy, old.S.yx + dt * change.yx, old.S.yy + dt * change.yy}};
}

/// Cauchy stress, sigma = -p I + S, in-plane part [kPa].
template <class Real>
[[gnu::always_inline]] inline TensorOf<Real> cauchy_stress(const Real& rho, const TensorOf<Real>& S, double K) {
  const Real p = pressure(rho, K);
  return {S.xx - p, S.xy, S.yx, S.yy - p};
}
inline Mat2 cauchy_stress(double rho, const Mat2& S, double K) { return matrix(cauchy_stress(rho, components(S), K)); }

/// First Piola-Kirchhoff stress P = J sigma F^-T [kPa].
/// @param F  deformation gradient [-]
template <class Real>
[[gnu::always_inline]] inline TensorOf<Real> piola_kirchhoff(const TensorOf<Real>& sigma, const TensorOf<Real>& F) {
  return {sigma.xx * F.yy - sigma.xy * F.xy, sigma.xy * F.xx - sigma.xx * F.yx, sigma.yx * F.yy - sigma.yy * F.xy,
          sigma.yy * F.xx - sigma.yx * F.yx};
}
inline Mat2 piola_kirchhoff(const Mat2& sigma, const Mat2& F) {
  return matrix(piola_kirchhoff(components(sigma), components(F)));
}

/// Velocity gradient L = dF/dt F^-1 [1/s].
/// @param rate  dF/dt [1/s]   @param F  deformation gradient, det F > 0 [-]
template <class Real>
[[gnu::always_inline]] inline TensorOf<Real> velocity_gradient(const TensorOf<Real>& rate, const TensorOf<Real>& F) {
  const Real per_J = 1.0 / (F.xx * F.yy - F.xy * F.yx);
  return {per_J * (rate.xx * F.yy - rate.xy * F.yx), per_J * (rate.xy * F.xx - rate.xx * F.xy),
          per_J * (rate.yx * F.yy - rate.yy * F.yx), per_J * (rate.yy * F.xx - rate.yx * F.xy)};
}
inline Mat2 velocity_gradient(const Mat2& rate, const Mat2& F) {
  return matrix(velocity_gradient(components(rate), components(F)));
}

/// Von Mises stress of the plane-strain state with S_zz = -(S_xx + S_yy) [kPa].
inline double von_mises(const Mat2& S) {
  const double S_zz = -S.trace();
  return std::sqrt(1.5 * (S.squaredNorm() + S_zz * S_zz));
}

/// Pressure of a fluid or partly fluid particle: (1 - f) K max(0, rho - 1) [kPa]. It resists compression and not
/// tension (MODEL.md, I6). Test: tests/unit/ecm/loop/loop_test.cpp
/// @param f  f_degr, 1 intact, 0 fluid [-]   @param rho  summed density over that of the lattice [-]
template <class Real>
[[gnu::always_inline]] inline Real fluid_pressure(const Real& f, const Real& rho, double K) {
  using std::max;
  return (1.0 - f) * max(Real(0.0), pressure(rho, K));
}

} // namespace matrigrate
