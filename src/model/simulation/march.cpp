#include "simulation/march.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

/// Largest |v|^2, in SIMD lanes [um^2/s^2].
MATRIGRATE_SIMD
double max_squared_of(std::span<const Vec2> v) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> largest{};
  std::size_t i = 0;
  for (; i + lanes <= v.size(); i += lanes)
    for (std::size_t l = 0; l < lanes; ++l) {
      const double squared = v[i + l].x() * v[i + l].x() + v[i + l].y() * v[i + l].y();
      largest[l] = largest[l] < squared ? squared : largest[l];
    }
  for (; i < v.size(); ++i) largest[0] = std::max(largest[0], v[i].squaredNorm());
  return *std::ranges::max_element(largest);
}

double max_squared(std::span<const Vec2> v) {
  std::vector<double> largest((v.size() + light_grain - 1) / light_grain, 0.0);
  parallel_parts(largest.size(), [&](std::size_t k) {
    const std::size_t begin = k * light_grain;
    largest[k] = max_squared_of(v.subspan(begin, std::min(light_grain, v.size() - begin)));
  });
  return largest.empty() ? 0.0 : std::ranges::max(largest);
}

/// Of a particle of matrix or cells [um/s].
double max_speed(const State& s) {
  double squared = max_squared(s.ecm.v);
  for (const Cell& cell : s.cells)
    for (const CortexState* ring : {&cell.cortex, &cell.nucleus}) squared = std::max(squared, max_squared(ring->v));
  return std::sqrt(squared);
}

} // namespace

double step_to_try(const State& s, const Parameters& p, const StepLimits& limits) {
  const double shortest = shortest_step(p);
  const auto at = static_cast<std::uint64_t>(std::llround(s.t / shortest)) % (1U << max_halvings);
  double dt = at == 0 ? p.run.time_step : static_cast<double>(std::uint64_t{1} << std::countr_zero(at)) * shortest;
  constexpr double much = 1.2;
  const double max_move = much * usual_move * p.ecm.particle_spacing;
  const double v = max_speed(s);
  dt = std::min(dt, longest_step(p, limits));
  while (v * dt > max_move && dt > 1.5 * shortest) dt *= 0.5;
  return dt;
}

namespace {

/// Makes a step of dt [s], halved until nothing moves further than usual_move and no cell crosses itself.
/// @throws NumericalFailure as advance(), also if the shortest step is still too long; the state is then unchanged
void advance_adaptively(State& s, const Parameters& p, Workspace& w, const Loads& loads, double dt) {
  const double shortest = shortest_step(p);
  for (bool tried_once = false;; tried_once = true, dt *= 0.5) {
    const bool last = dt < 1.5 * shortest;
    const auto refused = advance(
        s, p, dt, w, loads,
        {.max_move = (last ? 0.5 : usual_move) * p.ecm.particle_spacing, .may_cross = last, .tried_once = tried_once});
    if (!refused) return;
    if (last) throw NumericalFailure(FailureCause::step_limit, refused->reason);
  }
}

bool is_adaptive(const Parameters& p) { return p.run.integrator == Integrator::adaptive; }

/// How exactly times agree [s].
double rounding(const Parameters& p) { return 1e-6 * shortest_step(p); }

double next_step(const State& s, const Parameters& p, const Workspace& w) {
  return is_adaptive(p) ? step_to_try(s, p, w.limits) : p.run.time_step;
}

/// A step of dt, or of less where the integrator is adaptive.
void make_step(State& s, const Parameters& p, double dt, Workspace& w, const Loads& loads = {}) {
  if (is_adaptive(p))
    advance_adaptively(s, p, w, loads, dt);
  else
    advance(s, p, dt, w, loads);
}

} // namespace

void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads,
           const std::function<bool(const State&)>& each_step) {
  require_stable_step(p, w.limits);
  const double slack = 0.5 * shortest_step(p);
  while (s.t < t_end - slack) {
    make_step(s, p, next_step(s, p, w), w, loads);
    if (each_step && !each_step(s)) return;
  }
}

bool march_within(State& s, const Parameters& p, Workspace& w, double t_end,
                  const std::function<bool(const State&)>& each_step) {
  require_stable_step(p, w.limits);
  const double latest = t_end + rounding(p);
  double dt = next_step(s, p, w);
  for (bool goes_on = true; goes_on && s.t + dt <= latest; dt = next_step(s, p, w)) {
    make_step(s, p, dt, w);
    goes_on = each_step(s);
  }
  return s.t + dt > latest;
}

bool is_before(const State& s, const Parameters& p, double t_end) { return s.t < t_end - rounding(p); }

bool is_within_step(double t, const Parameters& p) {
  const double dt = p.run.time_step;
  return std::abs(t - dt * std::round(t / dt)) > rounding(p);
}

void shorten_last_step(State& s, const Parameters& p, Workspace& w, double t_end) {
  while (is_before(s, p, t_end)) make_step(s, p, std::min(next_step(s, p, w), t_end - s.t), w);
  s.t = t_end; // the sum of times is rounded
}

} // namespace matrigrate
