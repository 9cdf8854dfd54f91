#pragma once

#include "ecm/loop/fibres.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <vector>

/// Fields of the matrix to look at, one value a particle; NaN in the fluid. Test: tests/unit/observe/frame_test.cpp
namespace matrigrate {

/// |u| [um].
std::vector<double> displacement_field(const EcmState& ecm);

/// Von Mises stress of the fibres, Heck et al. 2020, Eq. (11) [kPa].
std::vector<double> fibre_stress_field(const EcmState& ecm, const FibreParameters& p, const FibreNetwork& network);

} // namespace matrigrate
