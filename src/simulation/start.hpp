#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

namespace matrigrate {

/// Initial state of a migration, at rest: the disc of matrix with a hole of fluid, and the round cell in it.
State initial_state(const Parameters& p);

} // namespace matrigrate
