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

} // namespace matrigrate
