#include "simulation/advance.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "ecm/degradation.hpp"
#include "ecm/stress.hpp"
#include "ecm/updated_lagrangian.hpp"
#include "simulation/step_limits.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate {

namespace {

/// Solves A v = F into s.ecm.v, starting from the velocities of the last step.
void solve_velocities(State& s, const Parameters& p, Workspace& w) {
  std::vector<Vec2> v = s.ecm.v;
  w.health.solve = w.solver->solve(w.drag, v);
  if (!w.health.solve.converged)
    throw NumericalFailure(fmt::format("step {} (t = {:.6g} s): the drag system was not solved: relative residual "
                                       "{:.3g} after {} iterations, wanted {:.3g}",
                                       s.step + 1, s.t, w.health.solve.residual, w.health.solve.iterations,
                                       p.solver.tolerance));
  const double furthest = 0.5 * p.ecm.particle_spacing / p.run.time_step;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (v[i].allFinite() && v[i].norm() <= furthest) continue;
    throw NumericalFailure(fmt::format("step {} (t = {:.6g} s): the particle at ({:.4g}, {:.4g}) um would move {:.3g} "
                                       "um in one step of {:.4g} s, more than "
                                       "half a particle spacing; {}",
                                       s.step + 1, s.t, s.ecm.x[i].x(), s.ecm.x[i].y(), v[i].norm() * p.run.time_step,
                                       p.run.time_step, describe(step_limits(p))));
  }
  s.ecm.v = std::move(v);
}

void advance_material(State& s, const Parameters& p, Workspace& w) {
  const double dt = p.run.time_step;
  const DensityBounds bounds = p.ecm.formulation == Formulation::total_lagrangian
                                   ? advance_stress(s.ecm, p.ecm, w.reference, w.F, dt)
                                   : advance_current_stress(s.ecm, p.ecm, w.neighbours.pairs(), dt);
  w.health.density_bounds = bounds.below + bounds.above;
}

void advance_positions(State& s, double dt) {
  parallel_for(s.ecm.size(), [&](std::size_t i) { s.ecm.x[i] += dt * s.ecm.v[i]; });
}

} // namespace

void advance(State& s, const Parameters& p, Workspace& w, const Loads& loads) {
  // neighbours and shape at x(t)
  if (w.neighbours.update(s.ecm.x, s.ecm.period_x)) ++w.health.list_builds;
  w.reference.update(s.ecm);

  // momentum balance, Eq. 2: A v = F
  assemble_drag(s, p, w);
  assemble_forces(s, p, w, loads);
  solve_velocities(s, p, w);

  // density, stress, positions
  advance_material(s, p, w);
  advance_positions(s, p.run.time_step);

  // events
  w.health.orphans += fluidize_orphans(s.ecm, p.ecm, w.reference);

  ++s.step;
  s.t = static_cast<double>(s.step) * p.run.time_step;
}

void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads,
           const std::function<bool(const State&)>& each_step) {
  require_stable_step(p);
  while (s.t < t_end - 0.5 * p.run.time_step) {
    advance(s, p, w, loads);
    if (each_step && !each_step(s)) return;
  }
}

} // namespace matrigrate
