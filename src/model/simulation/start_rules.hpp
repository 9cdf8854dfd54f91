#pragma once

#include "parameters/rules.hpp"

#include <span>

/// Conditions on the parameters, besides rules(), for a run to start: a stable time step, allowed values of each field
/// and law,
/// obstacles clear of the cells, and fibres that match bonds of the lattice. Test:
/// tests/unit/simulation/start_rules_test.cpp
namespace matrigrate {

/// Each check needs about 10 ms.
std::span<const Rule> start_rules();

/// Those of them on the values of laws, without which a changed law may not be evaluated.
std::span<const Rule> law_rules();

} // namespace matrigrate
