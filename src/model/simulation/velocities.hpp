#pragma once

#include "simulation/equations.hpp"
#include "simulation/workspace.hpp"

#include <optional>
#include <string>

namespace matrigrate {

// The solve of a step, and the bounds on its velocities. Test: tests/physics/advance_test.cpp,
// tests/physics/march_test.cpp

/// Bounds of a step.
struct StepBounds {
  double max_move;         ///< maximum displacement of a particle of matrix or cells [um]
  bool may_cross = true;   ///< whether a ring may cross itself, or a nucleus its cortex, in the step
  bool tried_once = false; ///< whether Workspace::v is that of a longer, rejected step from this state
};

/// Why a step was rejected: the bound that it would have broken.
struct StepTooLong {
  std::string reason;
};

/// Velocities of matrix and cells if they go on changing as in the last step, in Workspace::v: the first guess of the
/// solver.
void extrapolate_velocities(const State& s, Workspace& w);

/// Completes F (simulation/equations.hpp) and solves A v = F, Eqs. (1) and (2), for the velocities of matrix and cells
/// in Workspace::v, from the first guess there.
/// @return the bound that a step of dt with these velocities would break, if any; the state is then unchanged, bit for
/// bit
/// @throws NumericalFailure if the system was not solved; the state is then unchanged
std::optional<StepTooLong> solve_velocities(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads,
                                            const StepBounds& bounds);

/// Makes Workspace::v the velocities of the state, and advances positions, density and stress by dt with them
/// (ecm/loop/stress), the stress by the change of F over the step. Growing protrusions spread, and anchors move with
/// the matrix. Test: tests/physics/advance_test.cpp
void move(State& s, const Parameters& p, double dt, Workspace& w);

} // namespace matrigrate
