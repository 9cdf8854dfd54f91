#include "observe/health.hpp"

#include "cell/geometry.hpp"

#include <fmt/format.h>

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

constexpr double least_area = 0.05;     // of the initial one; negative inside out
constexpr double most_imbalance = 1e-6; // rounding leaves less than 1e-9

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
  most_iterations = std::max(most_iterations, step.solve.iterations);
  largest_residual = std::max(largest_residual, step.solve.residual);
}

double force_imbalance(const Workspace& w) {
  Vec2 sum = -w.outer_force;
  double magnitudes = 0.0;
  for (const Vec2& force : w.force) {
    sum += force;
    magnitudes += force.norm();
  }
  return magnitudes > 0.0 ? sum.norm() / magnitudes : never;
}

HealthRow HealthWatch::row(const State& s, const Parameters& p, const StepHealth& last) {
  HealthRow row{.t = s.t,
                .step = s.step,
                .iterations = last.solve.iterations,
                .most_iterations = most_iterations,
                .residual = last.solve.residual,
                .largest_residual = largest_residual,
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

std::string alarm(const State& s, const Parameters& p, const HealthRow& row) {
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (!s.ecm.x[i].allFinite() || !s.ecm.S[i].allFinite() || !std::isfinite(s.ecm.rho[i]))
      return fmt::format("matrix particle {}, at the start at ({:.4g}, {:.4g}) um, has a value that is not finite", i,
                         s.ecm.X[i].x(), s.ecm.X[i].y());
  if (!s.has_cell()) return {};
  for (const Vec2& x : s.cortex.x)
    if (!x.allFinite()) return "a particle of the cortex has a position that is not finite";
  const Vec2 centre = centroid(s.cortex);
  const std::string place = fmt::format("the cell at ({:.4g}, {:.4g}) um", centre.x(), centre.y());
  if (row.area_ratio < least_area) return fmt::format("{} has {:.2g} of its area left", place, row.area_ratio);
  if (row.crosses_itself) return fmt::format("{} crosses itself", place);
  if (row.deepest_solid > p.ecm.particle_spacing)
    return fmt::format("solid matrix lies {:.3g} um deep inside {}", row.deepest_solid, place);
  if (row.force_imbalance > most_imbalance)
    return fmt::format("inner forces do not balance: their sum is {:.2g} of their magnitudes", row.force_imbalance);
  return {};
}

} // namespace matrigrate
