#pragma once

#include "parameters/parameters.hpp"

#include <vector>

/// Uniaxial stretch of fibrillar gels with free sides, quasi-static: on paper, and as a specimen.
/// Test: tests/unit/validation/fibre_gels_test.cpp
namespace matrigrate::validation {

/// A state of the stretch.
struct Stretch {
  double strain;         ///< along the pull
  double lateral_strain; ///< across it
  double stress;         ///< nominal [kPa]
};

/// The semi-affine law of Steinwachs et al. 2016: fibres in all directions of space follow the stretch, W = <w(|F e| -
/// 1)>; w'' is k_0 exp(strain/d_0) in compression (buckling, d_0 = 0.0008), k_0 up to eps_s, k_0 exp((strain -
/// eps_s)/d_s) beyond; both lateral directions are free.
/// @return nominal stress over k_0 [-]
double semi_affine_stress(double strain, double eps_s, double d_s);

/// An infinite lattice of fibres in its elastic rest, stretched homogeneously along x while the stress across vanishes;
/// in small increments up to `largest`.
std::vector<Stretch> affine_lattice(const Parameters& p, double largest, int increments);

/// A rectangle between grips, pulled along x in increments, each held until the specimen has come to rest.
std::vector<Stretch> pull_specimen(const Parameters& p, double largest, int increments);

/// Relative error of the specimen's stress: its two free edges are known to a spacing each [-].
double edge_error(const EcmParameters& p);

/// Linear interpolation of the stress of a curve that starts at the origin [kPa].
double stress_at(const std::vector<Stretch>& curve, double strain);

} // namespace matrigrate::validation
