#include "protrusion/deflection.hpp"

#include "base/points_in.hpp"
#include "protrusion/growth.hpp"
#include "sph/kernel.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

namespace matrigrate {

namespace {

Vec2 foremost(const CortexState& c, std::size_t centre, const Vec2& direction, const ProtrusionParameters& p) {
  const std::vector<std::size_t> tips = pushing_particles(c, centre, p);
  return c.x[*std::ranges::max_element(tips, {}, [&](std::size_t i) { return c.x[i].dot(direction); })];
}

/// Mean of the outward normals of the pushing particles.
Vec2 where_tip_points(const CortexState& c, std::size_t centre, std::span<const Vec2> normals,
                      const ProtrusionParameters& p) {
  Vec2 sum = Vec2::Zero();
  for (const std::size_t i : pushing_particles(c, centre, p)) sum += normals[i];
  return sum.normalized();
}

} // namespace

double deflection_speed(const EcmState& ecm, const Parameters& p, const Vec2& tip, const Vec2& direction,
                        const Vec2& ahead, const std::function<bool(const Vec2&)>& inside) {
  const Kernel kernel(p.ecm.smoothing_length);
  const double nearest = p.degradation.tip_distance;
  const double in_cone = std::cos(p.protrusion.deflection_cone);
  double sum = 0.0;
  double weights = 0.0;
  for (const std::uint32_t k : points_in(around(tip, kernel.support()), ecm.x)) {
    const Vec2 r = ecm.x[k] - tip;
    const double d = r.norm();
    if (d <= nearest || d >= kernel.support() || r.dot(direction) < in_cone * d || r.dot(ahead) < in_cone * d
        || inside(ecm.x[k]))
      continue;
    weights += kernel.W(d);
    sum += kernel.W(d) * (1.0 - ecm.f[k]) * cross(direction, r) / d;
  }
  return weights > 0.0 ? p.protrusion.deflection_rate * sum / weights : 0.0;
}

void deflect(Cell& cell, const EcmState& ecm, const Parameters& p, double dt, std::span<const Vec2> normals,
             const std::function<bool(const Vec2&)>& inside) {
  for (Protrusion& protrusion : cell.protrusions) {
    auto* growing = std::get_if<Growing>(&protrusion.phase);
    if (growing == nullptr) continue;
    const Vec2 tip = foremost(cell.cortex, protrusion.centre, growing->direction, p.protrusion);
    const Vec2 ahead = where_tip_points(cell.cortex, protrusion.centre, normals, p.protrusion);
    const double angle = dt * deflection_speed(ecm, p, tip, growing->direction, ahead, inside);
    growing->direction = (Eigen::Rotation2Dd(angle) * growing->direction).normalized();
  }
}

} // namespace matrigrate
