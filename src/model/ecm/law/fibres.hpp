#pragma once

#include "base/vector.hpp"
#include "parameters/parameters.hpp"

#include <algorithm>
#include <cmath>

/// Laws of one strain-stiffening fibre, Heck et al. 2020, Eqs. (3) and (5) (MODEL.md, I23-I26). For scalars only: few
/// fibres are taut, and there is no SIMD exponential. Test: tests/unit/ecm/loop/fibres_test.cpp
namespace matrigrate {

/// Growth of the stiffness beyond the onset: exp((strain - eps_s)/d_s) [-].
inline double stiffening(double strain, const FibreParameters& p) {
  return std::exp((strain - p.onset) / p.stiffening_strain);
}

/// Stiffness of a fibre, the slope of its force, Eq. (5): 0 in compression, k_0 up to eps_s, k_0 exp((strain -
/// eps_s)/d_s) beyond [kPa].
inline double fibre_stiffness(double strain, const FibreParameters& p) {
  if (strain < 0.0) return 0.0;
  return strain <= p.onset ? p.stiffness : p.stiffness * stiffening(strain, p);
}

/// Force of a fibre over w_ij |X_ij|, per depth [kPa]: the integral of the stiffness over the strain. 0 in compression.
inline double fibre_tension(double strain, const FibreParameters& p) {
  if (strain <= 0.0) return 0.0;
  if (strain <= p.onset) return p.stiffness * strain;
  return p.stiffness * (p.onset + p.stiffening_strain * (stiffening(strain, p) - 1.0));
}

/// Integral of fibre_tension() over the strain: energy of a fibre over w_ij |X_ij|^2, per depth [kPa].
inline double fibre_energy(double strain, const FibreParameters& p) {
  if (strain <= 0.0) return 0.0;
  if (strain <= p.onset) return 0.5 * p.stiffness * strain * strain;
  const double beyond = strain - p.onset;
  const double d = p.stiffening_strain;
  const double growth = stiffening(strain, p);
  const double below = 0.5 * p.onset * p.onset;
  return p.stiffness * (below + (p.onset - d) * beyond + d * d * (growth - 1.0));
}

/// Pull of particle j on i over t_z f_i f_j, Eq. (3), along x_ij [nN/um].
/// @param tension  fibre_tension() [kPa]   @param weight  w_ij [-]
inline Vec2 fibre_pull(double tension, double strain, const Vec2& x_ij, double weight) {
  return -weight * tension / (1.0 + strain) * x_ij;
}

} // namespace matrigrate
