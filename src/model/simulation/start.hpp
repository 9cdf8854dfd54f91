#pragma once

#include "base/failure.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <string>
#include <vector>

namespace matrigrate {

/// Initial state of a migration, at rest: the disc of matrix with its fields and a hole of fluid for
/// each cell, and the round cells in them.
/// @throws ConfigurationError if the file of a field is not there any more, or has changed
State initial_state(const Parameters& p);

// What cannot change while a simulation goes on. Test: tests/apps/resume_test.cpp

/// One fault for each parameter that differs and with which the initial state was made: geometry and
/// lattice of the matrix, fields, size and particles of cell and nucleus, number and places of the cells. (Fields
/// are kept by the particles, stiffness as a ratio to ecm.youngs_modulus.)
/// @param place  where the new values were given: "--set"
std::vector<Fault> faults_of_change(const Parameters& before, const Parameters& after, const std::string& place);

} // namespace matrigrate
