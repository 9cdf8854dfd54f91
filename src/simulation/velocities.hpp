#pragma once

#include "simulation/workspace.hpp"

#include <optional>
#include <string>

/// The solve of a step, and what refuses one. Test: tests/physics/advance_test.cpp, tests/physics/march_test.cpp
namespace matrigrate {

/// What a step may do.
struct StepBounds {
  double max_move;         ///< of a particle of matrix or cortex [um]
  bool may_cross = true;   ///< whether the cortex may come to cross itself in the step
  bool tried_once = false; ///< whether Workspace::v are the velocities of a longer step from here, which broke a bound
};

/// Why a step was not taken: which bound it would have broken.
struct StepTooLong {
  std::string reason;
};

/// Solves A v = F, Eqs. (1) and (2), for the velocities of matrix and cortex.
/// @return what a step of dt with these velocities would break, if anything: the state is then, bit by bit, as before
/// @throws NumericalFailure if the system was not solved; the state is then as before, too
std::optional<StepTooLong> solve_velocities(State& s, const Parameters& p, double dt, Workspace& w,
                                            const StepBounds& bounds);

} // namespace matrigrate
