#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

namespace matrigrate {

/// Initial state of a migration, at rest: the disc of matrix with its fields and a hole of fluid for
/// each cell, and the round cells in them.
/// @throws ConfigurationError if the file of a field is not there any more, or has changed
State initial_state(const Parameters& p);

} // namespace matrigrate
