#include "observe/health.hpp"

#include "cell/geometry.hpp"
#include "contact/nucleus.hpp"
#include "state/dof.hpp"

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

constexpr double least_area = 0.05;    // of the initial one; negative inside out
constexpr double max_imbalance = 1e-6; // rounding leaves less than 1e-9

void add_densities(HealthRow& row, const EcmState& ecm) {
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0) continue;
    row.density_min = std::fmin(row.density_min, ecm.rho[i]); // of a number and NaN: the number
    row.density_max = std::fmax(row.density_max, ecm.rho[i]);
  }
}

/// "the cell at (1.2, 3.4) um": that of the least value.
template <class Value>
std::string place(const State& s, const Value& value) {
  const Cell& cell = s.cells.size() == 1
                         ? s.cells.front() // the value need not be worked out
                         : *std::ranges::min_element(s.cells, {}, [&](const Cell& c) { return value(c.cortex); });
  const Vec2 centre = centroid(cell.cortex);
  return fmt::format("the cell at ({:.4g}, {:.4g}) um", centre.x(), centre.y());
}

} // namespace

SolidInside solid_inside(const EcmState& ecm, const CortexState& c) {
  SolidInside inside;
  Vec2 low = c.x.front();
  Vec2 high = low;
  for (const Vec2& x : c.x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const Vec2& x = ecm.x[i];
    if (ecm.f[i] <= 0.0 || (x.array() < low.array()).any() || (x.array() > high.array()).any()) continue;
    if (!contains(c, x)) continue;
    ++inside.n;
    inside.deepest = std::max(inside.deepest, distance(c, x));
  }
  return inside;
}

void HealthWatch::see(const StepHealth& step) {
  max_iterations = std::max(max_iterations, step.solve.iterations);
  largest_residual = std::max(largest_residual, step.solve.residual);
}

double force_imbalance(const Workspace& w) {
  Vec2 sum = -w.outer_force;
  double magnitudes = 0.0;
  for (const Vec2& force : w.force) {
    sum += force;
    magnitudes += force.norm();
  }
  return magnitudes > 0.0 ? sum.norm() / magnitudes : undefined;
}

HealthRow HealthWatch::row(const State& s, const Parameters& p, const StepHealth& last) {
  HealthRow row{.t = s.t,
                .step = s.step,
                .iterations = last.solve.iterations,
                .max_iterations = max_iterations,
                .residual = last.solve.residual,
                .largest_residual = largest_residual,
                .density_bounds = last.density_bounds,
                .orphans = last.orphans,
                .torn = last.torn,
                .engulfed = last.engulfed,
                .fastest = fastest(node_velocities(s))};
  add_densities(row, s.ecm);
  for (const Cell& cell : s.cells) {
    const SolidInside inside = solid_inside(s.ecm, cell.cortex);
    row.area_ratio = std::fmin(row.area_ratio, area(cell.cortex) / initial_area(p.cell));
    row.solid_inside += inside.n;
    row.deepest_solid = std::max(row.deepest_solid, inside.deepest);
    row.crosses_itself = row.crosses_itself || crosses_itself(cell.cortex);
  }
  *this = HealthWatch{};
  return row;
}

std::optional<Alarm> alarm(const State& s, const Parameters& p, const HealthRow& row) {
  using Cause = FailureCause;
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (!s.ecm.x[i].allFinite() || !s.ecm.S[i].allFinite() || !std::isfinite(s.ecm.rho[i]))
      return Alarm{
          Cause::not_finite,
          fmt::format("matrix particle {}, at the start at ({:.4g}, {:.4g}) um, has a value that is not finite", i,
                      s.ecm.X[i].x(), s.ecm.X[i].y())};
  if (s.cells.empty()) return {};
  for (const Cell& cell : s.cells)
    for (const CortexState* ring : {&cell.cortex, &cell.nucleus})
      for (const Vec2& x : ring->x)
        if (!x.allFinite())
          return Alarm{Cause::not_finite,
                       "a particle of the cortex or of the nucleus has a position that is not finite"};
  if (row.area_ratio < least_area)
    return Alarm{Cause::collapse, fmt::format("{} has {:.2g} of its area left", place(s, area), row.area_ratio)};
  if (row.crosses_itself)
    return Alarm{Cause::crossing, fmt::format("{} crosses itself", place(s, [](const CortexState& c) {
                                                return crosses_itself(c) ? 0 : 1;
                                              }))};
  if (const auto found = std::ranges::find_if(s.cells, nucleus_outside); found != s.cells.end()) {
    const Vec2 centre = centroid(found->nucleus);
    return Alarm{
        FailureCause::nucleus_outside,
        fmt::format("the nucleus at ({:.4g}, {:.4g}) um has passed through the cortex", centre.x(), centre.y())};
  }
  if (row.deepest_solid > p.ecm.particle_spacing)
    return Alarm{Cause::solid_inside,
                 fmt::format("solid matrix lies {:.3g} um deep inside {}", row.deepest_solid,
                             place(s, [&](const CortexState& c) { return -solid_inside(s.ecm, c).deepest; }))};
  if (row.force_imbalance > max_imbalance)
    return Alarm{
        Cause::imbalance,
        fmt::format("inner forces do not balance: their sum is {:.2g} of the sum of magnitudes", row.force_imbalance)};
  return {};
}

} // namespace matrigrate
