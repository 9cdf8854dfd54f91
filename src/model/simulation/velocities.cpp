#include "simulation/velocities.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "cell/geometry.hpp"
#include "contact/nucleus.hpp"
#include "ecm/loop/stress.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"
#include "simulation/step_limits.hpp"
#include "state/dof.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace matrigrate {

namespace {

void require_solved(const State& s, const Parameters& p, const SolveReport& solve) {
  if (solve.converged) return;
  throw NumericalFailure(FailureCause::solver,
                         fmt::format("step {} (t = {:.6g} s): the drag system was not solved: relative residual "
                                     "{:.3g} after {} iterations, wanted {:.3g}",
                                     s.step + 1, s.t, solve.residual, solve.iterations, solver_tolerance(p)));
}

/// What a node is a particle of.
std::string_view body_of(const State& s, std::size_t node) {
  if (in_matrix(s, node)) return "matrix";
  std::size_t cell = 0;
  while (node >= first_node(s, cell + 1)) ++cell;
  return node < first_nucleus_node(s, cell) ? "cortex" : "nucleus";
}

/// Whether any |v|^2 exceeds `limit` or is not a number.
MATRIGRATE_SIMD
bool any_faster(std::span<const Vec2> v, double limit) {
  std::uint64_t faster = 0;
  for (const Vec2& a : v) faster |= a.x() * a.x() + a.y() * a.y() <= limit ? 0U : 1U;
  return faster != 0;
}

/// The first particle that would move further than `max_move`, if any.
std::optional<StepTooLong> too_far(const State& s, double dt, const StepLimits& limits, std::span<const Vec2> v,
                                   double max_move) {
  const double max_speed = max_move / dt;
  const auto faster = [&](std::size_t begin, std::size_t end) {
    return any_faster(v.subspan(begin, end - begin), max_speed * max_speed);
  };
  if (!parallel_any(v.size(), faster)) return {};
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i].squaredNorm() <= max_speed * max_speed) continue; // false for what is not a number
    return StepTooLong{fmt::format(
        "step {} (t = {:.6g} s): the {} particle at ({:.4g}, {:.4g}) um would move {:.3g} um in one step of {:.4g} s, "
        "beyond the limit of {:.3g} um; {}",
        s.step + 1, s.t, body_of(s, i), node_position(s, i).x(), node_position(s, i).y(), v[i].norm() * dt, dt,
        max_move, describe(limits))};
  }
  return {};
}

/// A ring after the step.
CortexState moved(const CortexState& ring, double dt, std::span<const Vec2> v) {
  CortexState next{.x = ring.x, .v = {}, .l0 = {}};
  for (std::size_t i = 0; i < next.size(); ++i) next.x[i] += dt * v[i];
  return next;
}

/// Whether the step would make the cortex of a cell, or its nucleus, cross itself, or the nucleus leave the cell.
std::optional<StepTooLong> crossing(const State& s, double dt, std::span<const Vec2> v) {
  const auto refused = [&](std::string_view what) {
    return StepTooLong{fmt::format("step {} (t = {:.6g} s): {} in one step of {:.4g} s", s.step + 1, s.t, what, dt)};
  };
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    const Cell& cell = s.cells[k];
    Cell next;
    next.cortex = moved(cell.cortex, dt, of_cell(s, k, v));
    if (crosses_itself(next.cortex) && !crosses_itself(cell.cortex)) return refused("the cell would cross itself");
    if (cell.nucleus.size() == 0) continue;
    next.nucleus = moved(cell.nucleus, dt, of_nucleus(s, k, v));
    if (crosses_itself(next.nucleus) && !crosses_itself(cell.nucleus)) return refused("the nucleus would cross itself");
    if (nucleus_outside(next) && !nucleus_outside(cell)) return refused("the nucleus would pass through the cortex");
  }
  return {};
}

} // namespace

void extrapolate_velocities(const State& s, Workspace& w) {
  node_velocities(s, w.v_now);
  parallel_copy(std::span<const Vec2>(w.v_now), w.v);
  const std::vector<Vec2>& v_before = s.solver_memory.v_before;
  if (v_before.size() != w.v.size()) return;
  const auto go_on = [v = w.v.data(), before = v_before.data()](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) v[i] = 2.0 * v[i] - before[i];
  };
  each_unflagged_stretch(s.ecm.clamped, go_on);
  go_on(s.ecm.size(), w.v.size());
}

std::optional<StepTooLong> solve_velocities(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads,
                                            const StepBounds& bounds) {
  if (loads) complete_forces(s, p, w, loads); // they may be the caller's code, which stays on its thread
  const auto find_F = [&] {
    if (!loads) complete_forces(s, p, w, {});
  };
  w.health.solve = w.solver->solve(w.drag, find_F, w.v);
  require_solved(s, p, w.health.solve);
  std::optional<StepTooLong> further, crossed;
  side_by_side({[&] { further = too_far(s, dt, w.limits, w.v, bounds.max_move); },
                [&] {
                  if (!bounds.may_cross) crossed = crossing(s, dt, w.v);
                }});
  if (further || crossed) return further ? further : crossed;
  std::swap(s.solver_memory.v_before, w.v_now);
  std::swap(s.solver_memory.x_drag, w.drag_cache.x_drag());
  return {};
}

namespace {

void move(CortexState& ring, double dt, std::span<const Vec2> v) {
  ring.v.assign(v.begin(), v.end());
  for (std::size_t i = 0; i < ring.size(); ++i) ring.x[i] += dt * v[i];
}

void move_cells(State& s, const Parameters& p, double dt, const Workspace& w) {
  const std::span<const Vec2> v(w.v);
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    move(s.cells[k].cortex, dt, of_cell(s, k, v));
    move(s.cells[k].nucleus, dt, of_nucleus(s, k, v));
    spread_evenly(s.cells[k], p.protrusion, dt);
    move_anchors(s.cells[k], v, w.cells[k].anchor_weights, dt);
  }
}

} // namespace

void move(State& s, const Parameters& p, double dt, Workspace& w) {
  side_by_side({[&] { move_cells(s, p, dt, w); },
                [&] {
                  const auto go = [v = w.v.data(), to = s.ecm.v.data(), x = s.ecm.x.data(), dt](auto begin, auto end) {
                    for (std::size_t i = begin; i < end; ++i) x[i] += dt * (to[i] = v[i]);
                  };
                  const DensityBounds bounds = advance_stress(s.ecm, p.ecm, w.reference, w.solid, dt, go);
                  w.health.density_bounds = bounds.below + bounds.above;
                }});
}

} // namespace matrigrate
