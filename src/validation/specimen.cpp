#include "validation/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace matrigrate::validation {

Loads body_force(const Parameters& p, const Vec2& b) {
  return [t_z = p.ecm.thickness, b](const State& s, std::span<Vec2> force) {
    for (std::size_t i = 0; i < s.ecm.size(); ++i)
      if (!s.ecm.clamped[i]) force[i] += s.ecm.V0 * t_z * b;
  };
}

void drive_clamped(Simulation& a, const std::function<Vec2(const Vec2&)>& u, double seconds, const Loads& loads) {
  EcmState& ecm = a.s.ecm;
  const double steps = std::round(seconds / a.p.run.time_step);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) ecm.v[i] = u(ecm.X[i]) / (steps * a.p.run.time_step);
  a.march_for(steps * a.p.run.time_step, loads);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) ecm.v[i].setZero();
}

Vec2 mid_displacement(const EcmState& ecm, const EcmParameters& p) {
  Vec2 sum = Vec2::Zero();
  int count = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.clamped[i] || std::abs(ecm.X[i].y()) > 0.51 * p.particle_spacing) continue;
    sum += ecm.displacement(i);
    ++count;
  }
  return sum / std::max(count, 1);
}

double wall_distance(const EcmState& ecm) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) nearest = std::min(nearest, std::abs(ecm.X[i].y()));
  return 2.0 * nearest;
}

} // namespace matrigrate::validation
