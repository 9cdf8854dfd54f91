#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

namespace matrigrate {

/// The start of a migration: the disc of matrix with a hole of fluid, and the round cell in it, all at rest.
State initial_state(const Parameters& p);

} // namespace matrigrate
