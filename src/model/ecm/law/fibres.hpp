#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

#include <algorithm>
#include <cmath>

/// Laws of one strain-stiffening fibre, Heck et al. 2020, Eqs. (3) and (5) (MODEL.md, I23-I26). For scalars only: few
/// fibres are taut, and there is no SIMD exponential. Test: tests/unit/ecm/loop/fibres_test.cpp
namespace matrigrate {

/// Stiffness k_0 of a fibre in the plane: the parameter, times 8/15 if it is meant for fibres in space. 8/15 is the
/// mean of cos^4 over directions in space divided by that in the plane [kPa].
inline double k_0(const FibreParameters& p) { return p.plane_to_space ? 8.0 / 15.0 * p.stiffness : p.stiffness; }

/// Growth of the stiffness beyond the onset: exp((strain - eps_s)/d_s) [-].
inline double stiffening(double strain, const FibreParameters& p) {
  return std::exp((strain - p.onset) / p.stiffening_strain);
}

/// Stiffness of a fibre, Eq. (5): 0 in compression, k_0 up to eps_s, k_0 exp((strain - eps_s)/d_s) beyond [kPa].
inline double fibre_stiffness(double strain, const FibreParameters& p) {
  if (strain < 0.0) return 0.0;
  return strain <= p.onset ? k_0(p) : k_0(p) * stiffening(strain, p);
}

/// Force of a fibre over w_ij |X_ij|, per depth [kPa]: the integral of the stiffness over the strain (tangent law), or
/// stiffness times strain (secant law). 0 in compression.
inline double fibre_tension(double strain, const FibreParameters& p) {
  if (strain <= 0.0) return 0.0;
  if (p.law == FibreLaw::secant || strain <= p.onset) return fibre_stiffness(strain, p) * strain;
  return k_0(p) * (p.onset + p.stiffening_strain * (stiffening(strain, p) - 1.0));
}

/// Slope of fibre_tension() [kPa].
inline double fibre_slope(double strain, const FibreParameters& p) {
  const double k = fibre_stiffness(strain, p);
  return p.law == FibreLaw::secant && strain > p.onset ? k * (1.0 + strain / p.stiffening_strain) : k;
}

/// Integral of fibre_tension() over the strain: energy of a fibre over w_ij |X_ij|^2, per depth [kPa].
inline double fibre_energy(double strain, const FibreParameters& p) {
  if (strain <= 0.0) return 0.0;
  if (strain <= p.onset) return 0.5 * k_0(p) * strain * strain;
  const double beyond = strain - p.onset;
  const double d = p.stiffening_strain;
  const double growth = stiffening(strain, p);
  const double below = 0.5 * p.onset * p.onset;
  if (p.law == FibreLaw::tangent) return k_0(p) * (below + (p.onset - d) * beyond + d * d * (growth - 1.0));
  return k_0(p) * (below + d * (strain * growth - p.onset) - d * d * (growth - 1.0));
}

/// Pull of particle j on i over t_z f_i f_j, Eq. (3): along x_ij (axial), or along x_ij - X_ij (vectorial) [nN/um].
/// @param weight  w_ij [-]
inline Vec2 fibre_pull(double strain, const Vec2& x_ij, const Vec2& X_ij, double weight, const FibreParameters& p) {
  if (p.pull == FibreForce::axial) return -weight * fibre_tension(strain, p) / (1.0 + strain) * x_ij;
  const double secant = strain > 1e-12 ? fibre_tension(strain, p) / strain : k_0(p); // also where the strain is 0
  return -weight * secant * (x_ij - X_ij);
}

} // namespace matrigrate
