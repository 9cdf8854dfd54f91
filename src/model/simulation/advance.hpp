#pragma once

#include "simulation/equations.hpp"
#include "simulation/velocities.hpp"

#include <optional>

/// One time step. Its order of operations is a modelling decision: MODEL.md, "Order of a step".
/// Test: tests/physics/advance_test.cpp, tests/physics/migration_test.cpp
namespace matrigrate {

/// Advances the state by dt, unless the step would break a bound.
/// @param dt     at most run.time_step, the longest step of the run [s]
/// @param loads  forces from outside the model
/// @return the bound that the step would break; the state is then unchanged, bit for bit
/// @throws NumericalFailure if the drag system cannot be solved (the state is then unchanged), or if a cell has
///         reached the rim (the state is then that after the step)
[[nodiscard]] std::optional<StepTooLong> advance(State& s, const Parameters& p, double dt, Workspace& w,
                                                 const Loads& loads, const StepBounds& bounds);

/// The same, but throws where the other overload returns a bound; a particle may move by up to half a spacing.
/// @throws NumericalFailure also if one would move further; the state is then unchanged
void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads = {});

} // namespace matrigrate
