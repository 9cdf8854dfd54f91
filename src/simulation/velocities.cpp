#include "simulation/velocities.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "simulation/step_limits.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

/// Where a node is: a particle of the matrix, or of the cortex behind them.
const Vec2& position(const State& s, std::size_t node) {
  return node < s.ecm.size() ? s.ecm.x[node] : s.cortex.x[node - s.ecm.size()];
}

/// Velocities of matrix and cortex if they go on changing as in the last step: the first guess of the solver.
void extrapolate(const State& s, std::vector<Vec2>& v) {
  v = s.ecm.v;
  v.insert(v.end(), s.cortex.v.begin(), s.cortex.v.end());
  const std::vector<Vec2>& v_before = s.solver_memory.v_before;
  if (v_before.size() != v.size()) return;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (i >= s.ecm.size() || !s.ecm.clamped[i]) v[i] = 2.0 * v[i] - v_before[i];
}

void require_solved(const State& s, const Parameters& p, const SolveReport& solve) {
  if (solve.converged) return;
  throw NumericalFailure(fmt::format("step {} (t = {:.6g} s): the drag system was not solved: relative residual "
                                     "{:.3g} after {} iterations, wanted {:.3g}",
                                     s.step + 1, s.t, solve.residual, solve.iterations, solver_tolerance(p)));
}

/// The first particle that would move further than `max_move`, if any.
std::optional<StepTooLong> too_far(const State& s, double dt, const StepLimits& limits, std::span<const Vec2> v,
                                   double max_move) {
  const double max_speed = max_move / dt;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i].squaredNorm() <= max_speed * max_speed) continue; // false for what is not a number
    return StepTooLong{fmt::format(
        "step {} (t = {:.6g} s): the {} particle at ({:.4g}, {:.4g}) um would move {:.3g} um in one step of {:.4g} s, "
        "beyond the limit of {:.3g} um; {}",
        s.step + 1, s.t, i < s.ecm.size() ? "matrix" : "cortex", position(s, i).x(), position(s, i).y(),
        v[i].norm() * dt, dt, max_move, describe(limits))};
  }
  return {};
}

/// Whether the step would make the cortex cross itself.
std::optional<StepTooLong> crossing(const State& s, double dt, std::span<const Vec2> v) {
  CortexState next{.x = s.cortex.x, .v = {}, .l0 = {}};
  for (std::size_t i = 0; i < next.size(); ++i) next.x[i] += dt * v[s.node(i)];
  if (!crosses_itself(next) || crosses_itself(s.cortex)) return {};
  return StepTooLong{
      fmt::format("step {} (t = {:.6g} s): the cell would cross itself in one step of {:.4g} s", s.step + 1, s.t, dt)};
}

/// Makes v the velocities of matrix and cortex.
void accept(State& s, Workspace& w) {
  SolverMemory& memory = s.solver_memory;
  memory.x_drag = w.drag_cache.x_drag();
  memory.v_before = s.ecm.v;
  memory.v_before.insert(memory.v_before.end(), s.cortex.v.begin(), s.cortex.v.end());
  const auto cell = w.v.begin() + static_cast<std::ptrdiff_t>(s.ecm.size());
  s.ecm.v.assign(w.v.begin(), cell);
  s.cortex.v.assign(cell, w.v.end());
}

} // namespace

std::optional<StepTooLong> solve_velocities(State& s, const Parameters& p, double dt, Workspace& w,
                                            const StepBounds& bounds) {
  if (!bounds.tried_once) extrapolate(s, w.v);
  w.health.solve = w.solver->solve(w.drag, w.v);
  require_solved(s, p, w.health.solve);
  if (auto refused = too_far(s, dt, w.limits, w.v, bounds.max_move)) return refused;
  if (!bounds.may_cross)
    if (auto refused = crossing(s, dt, w.v)) return refused;
  accept(s, w);
  return {};
}

} // namespace matrigrate
