#pragma once

#include "parameters/parameters.hpp"

#include <vector>

/// Uniaxial stretch of fibrillar gels, quasi-static: on paper, and as a specimen.
/// Test: tests/unit/validation/validation_test.cpp
namespace matrigrate::validation {

inline constexpr double largest_strain = 0.16; ///< of the specimens and the lattice
inline constexpr int strip_increments = 16;    ///< of a specimen, 0.01 each
inline constexpr int lattice_increments = 160; ///< of the infinite lattice

/// The sides of a gel that is stretched. Extensional rheometers hold wide, flat samples: their sides cannot move in,
/// and the deformation gradient is diag(1 + strain, 1, 1).
enum class Sides { held, free };

/// A state of the stretch.
struct Stretch {
  double strain;         ///< along the pull
  double lateral_strain; ///< across it
  double stress;         ///< nominal [kPa]
};

/// The semi-affine law of Steinwachs et al. 2016: fibres in all directions of space follow the stretch, W = <w(|F e| -
/// 1)>; w'' is k_0 exp(strain/d_0) in compression (buckling, d_0 = 0.0008), k_0 up to eps_s, k_0 exp((strain -
/// eps_s)/d_s) beyond.
/// @param sides  of both lateral directions
/// @return nominal stress over k_0 [-]
double semi_affine_stress(double strain, double eps_s, double d_s, Sides sides);

/// An infinite lattice of fibres in its elastic rest, stretched homogeneously along x in small increments up to
/// `largest`. Free sides: the stress across vanishes. p.fibres.direction_deg is measured from the pull.
std::vector<Stretch> affine_lattice(const Parameters& p, double largest, int increments, Sides sides);

/// A strip with held sides (periodic across the pull, clamped at both ends), pulled in increments, each held until the
/// specimen is at rest. p.fibres.direction_deg is measured from the pull.
std::vector<Stretch> pull_strip(const Parameters& p, double largest, int increments);

/// Linear interpolation of the stress of a curve that starts at the origin [kPa]; not a number beyond its end.
double stress_at(const std::vector<Stretch>& curve, double strain);

} // namespace matrigrate::validation
