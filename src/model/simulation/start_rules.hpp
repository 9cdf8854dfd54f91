#pragma once

#include "parameters/rules.hpp"

#include <span>

/// Conditions on the parameters, besides rules(), for a run to start: a stable time step, allowed values of each field
/// and law, obstacles clear of the cells, and fibres that match bonds of the lattice.
/// Test: tests/unit/simulation/start_rules_test.cpp
namespace matrigrate {

/// Each check needs about 10 ms.
std::span<const Rule> start_rules();

/// Those of them on formulas, without which none may be evaluated: the values of laws, the comparisons of fields.
std::span<const Rule> formula_rules();

} // namespace matrigrate
