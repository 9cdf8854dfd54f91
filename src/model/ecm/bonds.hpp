#pragma once

#include "parameters/parameters.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Bonds of the lattice that fibres can lie on. Test: tests/unit/ecm/ecm_test.cpp
namespace matrigrate {

/// Directions of the bonds of a particle to its reference neighbours (distance below 2h): distinct angles in [0, 180)
/// degrees from the x axis, ascending.
std::vector<double> bond_directions(const EcmParameters& ecm);

/// The bonds of a particle inside the lattice that carry fibres.
struct FibreBonds {
  std::size_t count = 0;
  std::optional<double> mean_deg; ///< weighted mean axis, in [0, 180) degrees; none if there is no preferred axis
};

FibreBonds fibre_bonds(const Parameters& p);

/// Why the requested fibres do not fit the lattice: no bond matches their direction, or bonds of a hexagonal lattice
/// lie exactly on the boundary of half_angle_deg, where they make the gel stiff across its fibres.
/// @return the fault and a remedy; empty if there is none
std::string fault_of_fibres(const Parameters& p);

} // namespace matrigrate
