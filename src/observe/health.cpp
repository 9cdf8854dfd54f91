#include "observe/health.hpp"

#include "cell/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace matrigrate {

namespace {

/// Distance of a point from the ring [um].
double distance(const CortexState& c, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < c.size(); ++i)
    least = std::min(least, closest_point(point, c.x[i], c.x[c.next(i)]).from.squaredNorm());
  return std::sqrt(least);
}

double fastest(std::span<const Vec2> velocities) {
  double largest = 0.0;
  for (const Vec2& v : velocities) largest = std::max(largest, v.squaredNorm());
  return std::sqrt(largest);
}

void add_densities(HealthRow& row, const EcmState& ecm) {
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0) continue;
    row.density_min = std::fmin(row.density_min, ecm.rho[i]); // of a number and NaN: the number
    row.density_max = std::fmax(row.density_max, ecm.rho[i]);
  }
}

} // namespace

SolidInside solid_inside(const State& s) {
  SolidInside inside;
  if (!s.has_cell()) return inside;
  Vec2 low = s.cortex.x.front();
  Vec2 high = low;
  for (const Vec2& x : s.cortex.x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const Vec2& x = s.ecm.x[i];
    if (s.ecm.f[i] <= 0.0 || (x.array() < low.array()).any() || (x.array() > high.array()).any()) continue;
    if (!contains(s.cortex, x)) continue;
    ++inside.n;
    inside.deepest = std::max(inside.deepest, distance(s.cortex, x));
  }
  return inside;
}

void HealthWatch::see(const StepHealth& step) {
  m_most_iterations = std::max(m_most_iterations, step.solve.iterations);
  m_largest_residual = std::max(m_largest_residual, step.solve.residual);
}

HealthRow HealthWatch::row(const State& s, const Parameters& p, const StepHealth& last) {
  HealthRow row{.t = s.t,
                .step = s.step,
                .iterations = last.solve.iterations,
                .most_iterations = m_most_iterations,
                .residual = last.solve.residual,
                .largest_residual = m_largest_residual,
                .density_bounds = last.density_bounds,
                .orphans = last.orphans,
                .torn = last.torn,
                .engulfed = last.engulfed,
                .fastest = std::max(fastest(s.ecm.v), fastest(s.cortex.v))};
  add_densities(row, s.ecm);
  if (s.has_cell()) {
    const SolidInside inside = solid_inside(s);
    row.area_ratio = area(s.cortex) / initial_area(p.cell);
    row.solid_inside = inside.n;
    row.deepest_solid = inside.deepest;
    row.crosses_itself = crosses_itself(s.cortex);
  }
  *this = HealthWatch{};
  return row;
}

} // namespace matrigrate
