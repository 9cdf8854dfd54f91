#pragma once

#include "simulation/equations.hpp"

/// One step in time. Test: tests/physics
namespace matrigrate {

/// Advances the state by dt. The order of its lines is a modelling decision: MODEL.md, "Order of a step".
/// @param dt     at most run.time_step, the longest step of the run [s]
/// @param loads  forces from outside the model; none by default
/// @throws NumericalFailure if the drag system cannot be solved, or a particle would move further in the step than half
///         a spacing: the state is then, bit by bit, that before the step; also if the cell has reached the rim: the
///         state is then that after the step
void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads = {});

/// What a step may do.
struct StepBounds {
  double furthest_move;    ///< of a particle of matrix or cortex [um]
  bool may_cross = true;   ///< whether the cortex may come to cross itself in the step
  bool tried_once = false; ///< whether Workspace::v are the velocities of a longer step from here, which broke a bound
};

/// The same with other bounds.
/// @throws StepTooLong if one is broken; the state is then, bit by bit, that before the step
void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads, const StepBounds& bounds);

/// Advances until s.t has reached t_end [s] (to within half a step), after a check of the step against step_limits().
/// @param each_step  called after every step; returning false ends the march
/// @throws NumericalFailure, also if run.time_step is beyond a limit
void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads = {},
           const std::function<bool(const State&)>& each_step = {});

} // namespace matrigrate
