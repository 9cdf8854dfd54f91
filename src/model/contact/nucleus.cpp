#include "contact/nucleus.hpp"

#include "cell/geometry.hpp"
#include "contact/proximity.hpp"

#include <algorithm>
#include <numeric>

namespace matrigrate {

namespace {

/// Particles of one ring near the other, with the distance that is positive outside of the other.
template <class Take>
void near_ring(const CortexState& of, const CortexState& other, double reach, const Take& take) {
  const SegmentGrid grid(other, reach);
  for (std::uint32_t i = 0; i < of.size(); ++i)
    if (const auto near = closest_segment(of.x[i], other, grid, reach)) take(i, *near);
}

/// Force of a touch over the pressure [um^2]: half of the area that a particle of the round ring stands for.
double half_area(const NucleusTouch& touch, const Parameters& p) {
  CellParameters ring = p.cell;
  if (touch.of_nucleus) {
    ring.radius = p.nucleus.radius;
    ring.particles = p.nucleus.particles;
  }
  return 0.5 * initial_segment_length(ring) * p.ecm.thickness;
}

Vec2 mean(std::span<const Vec2> x) {
  return std::accumulate(x.begin(), x.end(), Vec2(0.0, 0.0)) / static_cast<double>(x.size());
}

} // namespace

double nucleus_pressure(double gap, const NucleusParameters& n) {
  return std::max(0.0, n.repulsion * (1.0 - gap / n.repulsion_range));
}

std::vector<NucleusTouch> nucleus_touches(const Cell& cell, const NucleusParameters& n) {
  std::vector<NucleusTouch> found;
  if (cell.nucleus.size() == 0) return found;
  const double reach = 2.0 * n.repulsion_range; // deeper overlaps are felt as well
  near_ring(cell.nucleus, cell.cortex, reach, [&](std::uint32_t i, const NearestSegment& near) {
    if (-near.distance < n.repulsion_range)
      found.push_back({true, i, near.segment, near.s, -near.distance, -near.normal});
  });
  near_ring(cell.cortex, cell.nucleus, reach, [&](std::uint32_t i, const NearestSegment& near) {
    if (near.distance < n.repulsion_range)
      found.push_back({false, i, near.segment, near.s, near.distance, near.normal});
  });
  return found;
}

void add_nucleus_contact(const Cell& cell, std::span<const NucleusTouch> touches, const Parameters& p, double dt,
                         std::uint32_t cortex, std::uint32_t nucleus, std::span<Vec2> force, DragSystem& A) {
  for (const NucleusTouch& t : touches) {
    const CortexState& other = t.of_nucleus ? cell.cortex : cell.nucleus;
    const std::uint32_t first = t.of_nucleus ? cortex : nucleus; // of the other
    const std::uint32_t i = (t.of_nucleus ? nucleus : cortex) + t.particle;
    const std::uint32_t a = first + t.segment;
    const auto b = static_cast<std::uint32_t>(first + other.next(t.segment));
    const double width = half_area(t, p);
    const Vec2 F = width * nucleus_pressure(t.gap, p.nucleus) * t.normal;
    force[i] += F;
    force[a] -= (1.0 - t.s) * F;
    force[b] -= t.s * F;
    A.directed.add(dt * width * p.nucleus.repulsion / p.nucleus.repulsion_range,
                   {{i, t.normal}, {a, -(1.0 - t.s) * t.normal}, {b, -t.s * t.normal}});
  }
}

Vec2 off_centre(const Cell& cell) { return mean(cell.cortex.x) - mean(cell.nucleus.x); }

void add_centring(const Cell& cell, const NucleusParameters& n, double dt, std::uint32_t cortex, std::uint32_t nucleus,
                  std::span<Vec2> force, DragSystem& A) {
  const Vec2 F = n.centring_stiffness * off_centre(cell);
  const double of_cortex = 1.0 / static_cast<double>(cell.cortex.size());
  const double of_nucleus = 1.0 / static_cast<double>(cell.nucleus.size());
  for (std::size_t i = 0; i < cell.cortex.size(); ++i) force[cortex + i] -= of_cortex * F;
  for (std::size_t i = 0; i < cell.nucleus.size(); ++i) force[nucleus + i] += of_nucleus * F;
  for (std::uint32_t i = 0; i < cell.cortex.size(); ++i) A.links.add_entry(cortex + i, of_cortex);
  for (std::uint32_t i = 0; i < cell.nucleus.size(); ++i) A.links.add_entry(nucleus + i, -of_nucleus);
  A.links.close(n.drag + dt * n.centring_stiffness);
}

bool nucleus_outside(const Cell& cell) {
  return std::ranges::any_of(cell.nucleus.x, [&cell](const Vec2& x) { return !contains(cell.cortex, x); });
}

} // namespace matrigrate
