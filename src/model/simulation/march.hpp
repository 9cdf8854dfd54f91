#pragma once

#include "simulation/equations.hpp"

#include <functional>

namespace matrigrate {

/// Advances until s.t has reached t_end [s] (to within half a step), by steps of run.time_step or of the adaptive
/// integrator. Checks the step against step_limits() first. Test: tests/physics/march_test.cpp
/// @param each_step  called after every step; returning false ends the march
/// @throws NumericalFailure, also if run.time_step is beyond a limit
void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads = {},
           const std::function<bool(const State&)>& each_step = {});

/// The same as long as no step passes t_end [s]. A longer march goes on with the same bits from there.
/// @param each_step  called after every step; returning false ends the march
/// @return whether no further step has room before t_end
/// @throws NumericalFailure as march()
bool march_within(State& s, const Parameters& p, Workspace& w, double t_end,
                  const std::function<bool(const State&)>& each_step);

/// Whether t_end [s] is still to come.
bool is_before(const State& s, const Parameters& p, double t_end);

/// Whether a time [s] is no multiple of run.time_step, so that a march may pass it by.
bool is_within_step(double t, const Parameters& p);

/// Goes on to t_end [s] itself by a shorter step, of which a longer march knows nothing.
/// @throws NumericalFailure as march()
void shorten_last_step(State& s, const Parameters& p, Workspace& w, double t_end);

// The adaptive integrator: steps of run.time_step, halved where a particle would move too far (MODEL.md, I29).
// Test: tests/unit/simulation/step_limits_test.cpp, tests/physics/march_test.cpp

/// The longest step to try from here [s]. It is stable, s.t is a multiple of it (so that the run reaches all multiples
/// of run.time_step), and at the speeds of the last step nothing would move much further than usual_move. A march
/// halves it until nothing moves further than that and no cell crosses itself.
double step_to_try(const State& s, const Parameters& p, const StepLimits& limits);

} // namespace matrigrate
