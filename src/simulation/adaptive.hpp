#pragma once

#include "simulation/equations.hpp"

/// The adaptive integrator: steps of run.time_step, halved where anything would move far (MODEL.md, D29).
/// Test: tests/unit/simulation/adaptive_test.cpp, tests/physics/march_test.cpp
namespace matrigrate {

/// The longest step from here that is worth a try: a stable one that s.t is a multiple of, so that the times of a run
/// meet all multiples of run.time_step, in which nothing moves much too far at the speeds of the last step [s].
double step_to_try(const State& s, const Parameters& p, const StepLimits& limits);

/// Takes that step, halved until nothing moves further than usual_move and the cell does not come to cross itself.
/// @throws NumericalFailure as advance(), also if the shortest step is still too long; the state is then as before
void advance_adaptively(State& s, const Parameters& p, Workspace& w, const Loads& loads);

} // namespace matrigrate
