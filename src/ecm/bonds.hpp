#pragma once

#include "parameters/parameters.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Which bonds a lattice has for fibres to lie on. Test: tests/unit/ecm/bonds_test.cpp
namespace matrigrate {

/// Directions of the bonds of a particle to its reference neighbours, those of a smaller distance than 2h: in [0, 180)
/// degrees from the x axis, ascending, each once.
std::vector<double> bond_directions(const EcmParameters& ecm);

/// The bonds of a particle inside the lattice that carry fibres.
struct FibreBonds {
  std::size_t count = 0;
  std::optional<double> mean_deg; ///< mean axis by weight, in [0, 180) degrees; none where no axis stands out
};

FibreBonds fibre_bonds(const Parameters& p);

/// Why the fibres that are asked for cannot be laid on the lattice: no bond meets their direction, or bonds of a
/// hexagonal lattice lie on the very boundary of half_angle_deg, where they make the gel stiff across its fibres.
/// @return what is wrong and what to take instead; empty if nothing is
std::string fault_of_fibres(const Parameters& p);

} // namespace matrigrate
