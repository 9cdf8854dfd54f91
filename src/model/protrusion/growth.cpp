#include "protrusion/growth.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace matrigrate {

namespace {

/// Moves the particles from one to the other, `count` segments apart along the ring in the direction of `side`, along
/// their contour by a share of their distance from equal spacing. Both ends stay.
void spread_between(CortexState& c, std::size_t from, int side, int count, double share) {
  const auto points = static_cast<std::size_t>(count) + 1;
  std::vector<Vec2> x(points);
  std::vector<double> at(points, 0.0); // arc length from the first particle
  for (std::size_t k = 0; k < points; ++k) {
    x[k] = c.x[c.along(from, side * static_cast<int>(k))];
    if (k > 0) at[k] = at[k - 1] + (x[k] - x[k - 1]).norm();
  }
  std::size_t piece = 0;
  for (std::size_t k = 1; k + 1 < points; ++k) {
    const double even = at.back() * static_cast<double>(k) / count;
    const double goal = at[k] + share * (even - at[k]);
    while (piece + 2 < points && at[piece + 1] < goal) ++piece;
    const double length = at[piece + 1] - at[piece];
    const double s = length > 0.0 ? (goal - at[piece]) / length : 0.0;
    c.x[c.along(from, side * static_cast<int>(k))] = x[piece] + s * (x[piece + 1] - x[piece]);
  }
}

} // namespace

std::vector<std::size_t> pushing_particles(const CortexState& c, std::size_t centre, const ProtrusionParameters& p) {
  std::vector<std::size_t> particles;
  for (int k = -p.tip_half_width; k <= p.tip_half_width; ++k) particles.push_back(c.along(centre, k));
  return particles;
}

Vec2 growth_force(const Vec2& direction, const Vec2& normal, const ProtrusionParameters& p) {
  return p.force / (2.0 * p.tip_half_width + 1.0) * std::max(0.0, normal.dot(direction)) * direction;
}

void add_growth(const Cell& cell, const ProtrusionParameters& p, double area, std::span<const Vec2> normals,
                std::uint32_t first, std::span<Vec2> force, DragSystem& A, double t, const Law& law,
                std::span<const LawPlace> places) {
  constexpr std::size_t of_speed = 3; // among the arguments of the law
  for (const Protrusion& protrusion : cell.protrusions) {
    const auto* growing = std::get_if<Growing>(&protrusion.phase);
    if (growing == nullptr) continue;
    const double length = protrusion_length(cell.cortex, protrusion.centre, p);
    const double speed = cell.cortex.v[protrusion.centre].dot(growing->direction);
    const LawPlace place = place_at(places, protrusion.centre);
    const double factor = law({area, length, t - protrusion.since, speed}, place);
    const double fall = law.fall(of_speed, {area, length, t - protrusion.since, speed}, place);
    for (const std::size_t i : pushing_particles(cell.cortex, protrusion.centre, p)) {
      const Vec2 full = growth_force(growing->direction, normals[i], p);
      force[first + i] += factor * full;
      if (fall <= 0.0) continue;
      const double drag = fall * full.norm();
      force[first + i] += drag * cell.cortex.v[i].dot(growing->direction) * growing->direction;
      A.directed.add(drag, {{static_cast<std::uint32_t>(first + i), growing->direction}});
    }
  }
}

void spread_evenly(Cell& cell, const ProtrusionParameters& p, double dt) {
  const double share = 1.0 - std::exp(-p.spreading_rate * dt);
  for (const Protrusion& protrusion : cell.protrusions)
    if (std::holds_alternative<Growing>(protrusion.phase))
      for (const int side : {-1, 1}) spread_between(cell.cortex, protrusion.centre, side, p.half_width, share);
}

double protrusion_length(const CortexState& c, std::size_t centre, const ProtrusionParameters& p) {
  const Vec2 base = 0.5 * (c.x[c.along(centre, -p.half_width)] + c.x[c.along(centre, p.half_width)]);
  return (c.x[centre] - base).norm();
}

double base_width(const CortexState& c, std::size_t centre, const ProtrusionParameters& p) {
  return (c.x[c.along(centre, p.half_width)] - c.x[c.along(centre, -p.half_width)]).norm();
}

void add_base_ties(const Cell& cell, const ProtrusionParameters& p, double k_s, double dt, std::uint32_t first,
                   std::span<Vec2> force, DragSystem& A) {
  const double stiffness = k_s / (2.0 * p.half_width);
  for (const Protrusion& protrusion : cell.protrusions) {
    const auto* growing = std::get_if<Growing>(&protrusion.phase);
    if (growing == nullptr) continue;
    const auto i = static_cast<std::uint32_t>(cell.cortex.along(protrusion.centre, -p.half_width));
    const auto j = static_cast<std::uint32_t>(cell.cortex.along(protrusion.centre, p.half_width));
    const std::uint32_t a = first + i;
    const std::uint32_t b = first + j;
    const Vec2 ab = cell.cortex.x[j] - cell.cortex.x[i];
    const double length = ab.norm();
    const double T = stiffness * (length - growing->base_width);
    if (T <= 0.0) continue;
    const Vec2 e = ab / length;
    force[a] += T * e;
    force[b] -= T * e;
    A.directed.add(dt * stiffness, {{a, e}, {b, -e}});
    A.directed.add(dt * T / length, {{a, perpendicular(e)}, {b, -perpendicular(e)}});
  }
}

void relax_rest_lengths(CortexState& c, std::size_t centre, const ProtrusionParameters& p) {
  for (int k = -p.half_width; k < p.half_width; ++k) {
    const std::size_t i = c.along(centre, k);
    c.l0[i] = (c.x[c.next(i)] - c.x[i]).norm();
  }
}

} // namespace matrigrate
