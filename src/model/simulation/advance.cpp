#include "simulation/advance.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "ecm/degradation.hpp"
#include "simulation/events.hpp"
#include "simulation/velocities.hpp"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <exception>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

std::span<const double> propensity_of(std::size_t cell, const Workspace& w) {
  return cell < w.propensity.size() ? std::span<const double>(w.propensity[cell]) : std::span<const double>();
}

void advance_protrusions(State& s, const Parameters& p, double dt, Workspace& w) {
  std::atomic<std::size_t> without_bias = 0;
  std::vector<std::exception_ptr> failures(s.cells.size());
  parallel_parts(w.laws.size(), [&](std::size_t part) {
    for (std::size_t k = part; k < s.cells.size(); k += w.laws.size()) try {
        if (advance_protrusions(s.cells[k], s.ecm, s.now(), p, dt, w.laws[part], propensity_of(k, w))) ++without_bias;
      } catch (...) {
        failures[k] = std::current_exception();
      }
  });
  for (const std::exception_ptr& failure : failures) // the first, for any number of threads
    if (failure) std::rethrow_exception(failure);
  w.without_bias = without_bias;
}

/// The next multiple of dt, whatever rounding left before; dt later from a time between multiples [s].
double time_after(double t, double dt) {
  const double steps = t / dt;
  return std::abs(steps - std::round(steps)) < 1e-6 ? (std::round(steps) + 1.0) * dt : t + dt;
}

} // namespace

std::optional<StepTooLong> advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads,
                                   const StepBounds& bounds) {
  // momentum balances at x(t), Eqs. 1 and 2: A v = F
  side_by_side({[&] { assemble(s, p, dt, w); },
                [&] {
                  if (!bounds.tried_once) extrapolate_velocities(s, w);
                }});
  if (auto refused = solve_velocities(s, p, dt, w, loads, bounds)) return refused;

  // positions, density, stress
  move(s, p, dt, w);
  ++s.step;
  s.t = time_after(s.t, dt);

  // events
  advance_attractant(s, p, dt, w);
  degrade_around_cells(s, p, dt, w);
  bool found = false;
  side_by_side(
      {[&] { advance_protrusions(s, p, dt, w); }, [&] { found = any_torn_or_orphan(s.ecm, p.ecm, w.reference); }});
  require_inside(s, p);
  if (!found) return {};
  w.health.torn += fluidize_torn(s.ecm, p.ecm);
  w.health.orphans += fluidize_orphans(s.ecm, p.ecm, w.reference);
  return {};
}

void advance(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads) {
  const auto refused = advance(s, p, dt, w, loads, {.max_move = 0.5 * p.ecm.particle_spacing});
  if (refused) throw NumericalFailure(FailureCause::step_limit, refused->reason);
}

} // namespace matrigrate
