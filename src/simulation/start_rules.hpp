#pragma once

#include "parameters/rules.hpp"

#include <span>

/// What parameters must fulfil, besides rules(), for a run to start: a time step that is stable, and fibres that lie on
/// bonds of the lattice. Test: tests/unit/simulation/start_rules_test.cpp
namespace matrigrate {

/// Each takes some 10 ms.
std::span<const Rule> start_rules();

} // namespace matrigrate
