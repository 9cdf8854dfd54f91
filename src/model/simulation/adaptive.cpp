#include "simulation/adaptive.hpp"

#include "base/failure.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace matrigrate {

namespace {

/// Largest |v|^2, in SIMD lanes [um^2/s^2].
MATRIGRATE_SIMD
double max_squared(std::span<const Vec2> v) {
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

void advance_adaptively(State& s, const Parameters& p, Workspace& w, const Loads& loads, double longest) {
  const double shortest = shortest_step(p);
  double dt = std::min(step_to_try(s, p, w.limits), longest);
  for (bool tried_once = false;; tried_once = true, dt *= 0.5) {
    const bool last = dt < 1.5 * shortest;
    const auto refused = advance(
        s, p, dt, w, loads,
        {.max_move = (last ? 0.5 : usual_move) * p.ecm.particle_spacing, .may_cross = last, .tried_once = tried_once});
    if (!refused) return;
    if (last) throw NumericalFailure(FailureCause::step_limit, refused->reason);
  }
}

} // namespace matrigrate
