#pragma once

#include "simulation/equations.hpp"

#include <limits>

/// The adaptive integrator: steps of run.time_step, halved where a particle would move too far (MODEL.md, I29).
/// Test: tests/unit/simulation/step_limits_test.cpp, tests/physics/march_test.cpp
namespace matrigrate {

/// The longest step to try from here [s]. It is stable, s.t is a multiple of it (so that the run reaches all multiples
/// of run.time_step), and at the speeds of the last step nothing would move much further than usual_move.
double step_to_try(const State& s, const Parameters& p, const StepLimits& limits);

/// Makes that step, halved until nothing moves further than usual_move and no cell crosses itself.
/// @param longest  of the step, to end between the multiples of run.time_step [s]
/// @throws NumericalFailure as advance(), also if the shortest step is still too long; the state is then unchanged
void advance_adaptively(State& s, const Parameters& p, Workspace& w, const Loads& loads,
                        double longest = std::numeric_limits<double>::infinity());

} // namespace matrigrate
