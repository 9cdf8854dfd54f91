#pragma once

#include "parameters/rules.hpp"
#include "state/state.hpp"

#include <span>

namespace matrigrate {

/// Initial state of a migration, at rest: the disc of matrix with its fields and a hole of fluid for
/// each cell, and the round cells in them.
/// @throws ConfigurationError if the file of a field is not there any more, or has changed
State initial_state(const Parameters& p);

/// Conditions on the parameters, besides rules(), for a run to start: a stable time step, allowed values of each field
/// and law, obstacles clear of the cells, and fibres that match bonds of the lattice. Each check needs about 10 ms.
/// Test: tests/unit/simulation/start_rules_test.cpp
std::span<const Rule> start_rules();

/// Those of them on formulas, without which none may be evaluated: the values of laws, the comparisons of fields.
std::span<const Rule> formula_rules();

} // namespace matrigrate
