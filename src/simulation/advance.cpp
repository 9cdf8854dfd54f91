#include "simulation/advance.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "cell/geometry.hpp"
#include "cell/rest_length.hpp"
#include "contact/degrade.hpp"
#include "ecm/degradation.hpp"
#include "ecm/stress.hpp"
#include "ecm/updated_lagrangian.hpp"
#include "ecm/viscosity.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/deflection.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "protrusion/life_cycle.hpp"
#include "protrusion/polarization.hpp"
#include "simulation/step_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

namespace matrigrate {

namespace {

/// Where a node is: a particle of the matrix, or of the cortex behind them.
const Vec2& position(const State& s, std::size_t node) {
  return node < s.ecm.size() ? s.ecm.x[node] : s.cortex.x[node - s.ecm.size()];
}

/// @throws StepTooLong if the step would make the cortex cross itself
void require_no_crossing(const State& s, double dt, std::span<const Vec2> v) {
  CortexState next{.x = s.cortex.x, .v = {}, .l0 = {}};
  for (std::size_t i = 0; i < next.size(); ++i) next.x[i] += dt * v[s.node(i)];
  if (!crosses_itself(next) || crosses_itself(s.cortex)) return;
  throw StepTooLong(
      fmt::format("step {} (t = {:.6g} s): the cell would cross itself in one step of {:.4g} s", s.step + 1, s.t, dt));
}

/// Velocities of matrix and cortex if they go on changing as in the last step.
void extrapolate(const State& s, std::vector<Vec2>& v) {
  v = s.ecm.v;
  v.insert(v.end(), s.cortex.v.begin(), s.cortex.v.end());
  if (s.v_before.size() != v.size()) return;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (i >= s.ecm.size() || !s.ecm.clamped[i]) v[i] = 2.0 * v[i] - s.v_before[i];
}

/// Solves A v = F into the velocities of matrix and cortex.
void solve_velocities(State& s, const Parameters& p, double dt, Workspace& w, const StepBounds& bounds) {
  std::vector<Vec2>& v = w.v;
  if (!bounds.tried_once) extrapolate(s, v);
  w.health.solve = w.solver->solve(w.drag, v);
  if (!w.health.solve.converged)
    throw NumericalFailure(fmt::format("step {} (t = {:.6g} s): the drag system was not solved: relative residual "
                                       "{:.3g} after {} iterations, wanted {:.3g}",
                                       s.step + 1, s.t, w.health.solve.residual, w.health.solve.iterations,
                                       solver_tolerance(p)));
  const double furthest = bounds.furthest_move / dt;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i].squaredNorm() <= furthest * furthest) continue; // false for what is not a number
    throw StepTooLong(fmt::format(
        "step {} (t = {:.6g} s): the {} particle at ({:.4g}, {:.4g}) um would move {:.3g} um in one step of {:.4g} s, "
        "beyond the limit of {:.3g} um; {}",
        s.step + 1, s.t, i < s.ecm.size() ? "matrix" : "cortex", position(s, i).x(), position(s, i).y(),
        v[i].norm() * dt, dt, bounds.furthest_move, describe(w.limits)));
  }
  if (!bounds.may_cross) require_no_crossing(s, dt, v); // nothing from here on throws: the state may change
  s.ecm.x_drag.swap(w.x_drag);
  s.v_before = s.ecm.v;
  s.v_before.insert(s.v_before.end(), s.cortex.v.begin(), s.cortex.v.end());
  const auto cell = v.begin() + static_cast<std::ptrdiff_t>(s.ecm.size());
  s.ecm.v.assign(v.begin(), cell);
  s.cortex.v.assign(cell, v.end());
}

void advance_positions(State& s, const Parameters& p, double dt, const Workspace& w) {
  parallel_for(s.ecm.size(), [&](std::size_t i) { s.ecm.x[i] += dt * s.ecm.v[i]; });
  for (std::size_t i = 0; i < s.cortex.size(); ++i) s.cortex.x[i] += dt * s.cortex.v[i];
  spread_evenly(s, p.protrusion, dt);
  move_anchors(s, w.cell.anchor_weights, dt);
}

/// Positions, density and stress. Reference neighbours give the change of F over the step, current ones its rate at the
/// start.
void move(State& s, const Parameters& p, double dt, Workspace& w) {
  DensityBounds bounds;
  switch (p.ecm.formulation) {
  case Formulation::total_lagrangian:
    advance_positions(s, p, dt, w);
    bounds = advance_stress(s.ecm, p.ecm, w.reference, w.solid, dt);
    break;
  case Formulation::updated_lagrangian:
    bounds = advance_current_stress(s.ecm, p.ecm, w.neighbours.pairs(), dt);
    advance_positions(s, p, dt, w);
    break;
  }
  w.health.density_bounds = bounds.below + bounds.above;
}

/// Degradation around tips, protrusions and body, of the particles met at x(t). Tips act from where they are in the
/// middle of the step: at its end they would run ahead of their own degradation, the more the longer the step.
void degrade_around_cell(State& s, const Parameters& p, double dt, Workspace& w) {
  std::vector<Vec2> tips;
  for (const Protrusion& protrusion : s.protrusions)
    if (std::holds_alternative<Growing>(protrusion.phase))
      for (const std::size_t i : pushing_particles(s.cortex, protrusion.centre, p.protrusion))
        tips.push_back(s.cortex.x[i] - 0.5 * dt * s.cortex.v[i]);
  degrade(s.ecm, p, w.cell.met, w.cell.membership.on_protrusion, tips, dt);
  w.health.engulfed += fluidize_engulfed(s.ecm, p, w.cell.met);
}

/// Front of the cell; all of it before the first protrusion.
std::vector<std::uint8_t> front_of(const State& s) {
  return s.polarization ? front(s.cortex, *s.polarization) : std::vector<std::uint8_t>(s.cortex.size(), 1);
}

void live_protrusions(State& s, const Parameters& p, double dt) {
  const Vec2 centre = centroid(s.cortex);
  const std::vector<Vec2> n = normals(s.cortex);
  deflect(s, p, dt, n, [&](const Vec2& point) { return contains(s.cortex, point); });
  live(s, p, dt);
  polarize(s, p.polarization, centre, dt);
  const std::vector<std::uint8_t> of_front = front_of(s);
  initiate(s, p, dt, {of_front, n, centre, area(s.cortex) / initial_area(p.cell)});
  ratchet_rest_lengths(s.cortex, p.cell, membership(s, p).soft);
}

void require_inside(const State& s, const Parameters& p) {
  const double room = p.ecm.radius - 4.0 * p.ecm.smoothing_length; // the rim and what feels it
  for (const Vec2& x : s.cortex.x)
    if (x.norm() > room)
      throw NumericalFailure(
          fmt::format("step {} (t = {:.6g} s): the cell has reached the clamped rim of the matrix at "
                      "({:.4g}, {:.4g}) um; take a larger ecm.radius",
                      s.step, s.t, x.x(), x.y()));
}

} // namespace

void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads) {
  advance(s, p, dt, w, loads, {.furthest_move = 0.5 * p.ecm.particle_spacing});
}

void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads, const StepBounds& bounds) {
  // neighbours, and shape of the cell, at x(t)
  w.elastic_share = elastic_share(p, dt, w.limits);
  update_neighbours(s, w);
  w.reference.update(s.ecm);
  describe_cell(s, p, w);

  // momentum balances, Eqs. 1 and 2: A v = F
  assemble_drag(s, p, dt, w);
  assemble_forces(s, p, dt, w, loads);
  solve_velocities(s, p, dt, w, bounds);

  // positions, density, stress
  move(s, p, dt, w);
  ++s.step;
  s.t = (std::round(s.t / dt) + 1.0) * dt; // the next multiple of dt, whatever rounding left before

  // events
  if (s.has_cell()) {
    degrade_around_cell(s, p, dt, w);
    live_protrusions(s, p, dt);
    require_inside(s, p);
  }
  w.health.torn += fluidize_torn(s.ecm, p.ecm);
  w.health.orphans += fluidize_orphans(s.ecm, p.ecm, w.reference);
}

namespace {

/// Of a particle of matrix or cortex [um/s].
double fastest(const State& s) {
  double squared = 0.0;
  for (const Vec2& v : s.ecm.v) squared = std::max(squared, v.squaredNorm());
  for (const Vec2& v : s.cortex.v) squared = std::max(squared, v.squaredNorm());
  return std::sqrt(squared);
}

/// The longest step that is worth a try: a stable one that s.t is a multiple of, in which nothing moves much too far at
/// the speeds of the last step.
double step_to_try(const State& s, const Parameters& p, const StepLimits& limits) {
  const double shortest = shortest_step(p);
  const auto at = static_cast<std::uint64_t>(std::llround(s.t / shortest)) % (1U << most_halvings);
  double dt = at == 0 ? p.run.time_step : static_cast<double>(std::uint64_t{1} << std::countr_zero(at)) * shortest;
  constexpr double much = 1.2;
  const double furthest = much * usual_move * p.ecm.particle_spacing;
  const double v = fastest(s);
  dt = std::min(dt, longest_step(p, limits));
  while (v * dt > furthest && dt > 1.5 * shortest) dt *= 0.5;
  return dt;
}

/// The next step of the adaptive integrator: halved until nothing moves further than usual_move.
void advance_adaptively(State& s, const Parameters& p, Workspace& w, const Loads& loads) {
  const double shortest = shortest_step(p);
  double dt = step_to_try(s, p, w.limits);
  for (bool tried_once = false;; tried_once = true, dt *= 0.5) {
    const bool last = dt < 1.5 * shortest;
    try {
      return advance(s, p, dt, w, loads,
                     {.furthest_move = (last ? 0.5 : usual_move) * p.ecm.particle_spacing,
                      .may_cross = last,
                      .tried_once = tried_once});
    } catch (const StepTooLong&) {
      if (last) throw;
    }
  }
}

} // namespace

void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads,
           const std::function<bool(const State&)>& each_step) {
  require_stable_step(p);
  const double slack = 0.5 * shortest_step(p);
  while (s.t < t_end - slack) {
    if (p.run.integrator == Integrator::adaptive)
      advance_adaptively(s, p, w, loads);
    else
      advance(s, p, p.run.time_step, w, loads);
    if (each_step && !each_step(s)) return;
  }
}

} // namespace matrigrate
