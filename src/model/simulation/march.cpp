#include "simulation/march.hpp"

#include "simulation/adaptive.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

bool is_adaptive(const Parameters& p) { return p.run.integrator == Integrator::adaptive; }

/// How exactly times agree [s].
double rounding(const Parameters& p) { return 1e-6 * shortest_step(p); }

/// Whether the next step would end at t_end or before.
bool has_room(const State& s, const Parameters& p, const Workspace& w, double t_end) {
  const double dt = is_adaptive(p) ? step_to_try(s, p, w.limits) : p.run.time_step;
  return s.t + dt <= t_end + rounding(p);
}

void make_step(State& s, const Parameters& p, Workspace& w, const Loads& loads) {
  if (is_adaptive(p))
    advance_adaptively(s, p, w, loads);
  else
    advance(s, p, p.run.time_step, w, loads);
}

} // namespace

void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads,
           const std::function<bool(const State&)>& each_step) {
  require_stable_step(p, w.limits);
  const double slack = 0.5 * shortest_step(p);
  while (s.t < t_end - slack) {
    make_step(s, p, w, loads);
    if (each_step && !each_step(s)) return;
  }
}

bool march_within(State& s, const Parameters& p, Workspace& w, double t_end,
                  const std::function<bool(const State&)>& each_step) {
  require_stable_step(p, w.limits);
  while (has_room(s, p, w, t_end)) {
    make_step(s, p, w, {});
    if (!each_step(s)) return !has_room(s, p, w, t_end);
  }
  return true;
}

bool is_before(const State& s, const Parameters& p, double t_end) { return s.t < t_end - rounding(p); }

bool is_within_step(double t, const Parameters& p) {
  const double dt = p.run.time_step;
  return std::abs(t - dt * std::round(t / dt)) > rounding(p);
}

void shorten_last_step(State& s, const Parameters& p, Workspace& w, double t_end) {
  while (is_before(s, p, t_end)) {
    if (is_adaptive(p))
      advance_adaptively(s, p, w, {}, t_end - s.t);
    else
      advance(s, p, std::min(p.run.time_step, t_end - s.t), w, {});
  }
  s.t = t_end; // the sum of times is rounded
}

} // namespace matrigrate
