#pragma once

#include "base/failure.hpp"
#include "parameters/parameters.hpp"

#include <string>
#include <vector>

/// What cannot change while a simulation goes on. Test: tests/apps/resume_test.cpp
namespace matrigrate {

/// One fault for each parameter that differs and with which the initial state was made: geometry and
/// lattice of the matrix, fields, size and particles of cell and nucleus, number and places of the cells. (Fields
/// are kept by the particles, stiffness as a ratio to ecm.youngs_modulus.)
/// @param place  where the new values were given: "--set"
std::vector<Fault> faults_of_change(const Parameters& before, const Parameters& after, const std::string& place);

} // namespace matrigrate
