#include "cell/bending.hpp"

#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

double rest_angle(const CortexState& c) { return 2.0 * std::numbers::pi / static_cast<double>(c.size()); }

/// Derivative of the direction of a vector e.
Vec2 direction_gradient(const Vec2& e) { return perpendicular(e) / e.squaredNorm(); }

} // namespace

double turning_angle(const CortexState& c, std::size_t i) {
  const Vec2 a = c.x[i] - c.x[c.previous(i)];
  const Vec2 b = c.x[c.next(i)] - c.x[i];
  return std::atan2(cross(a, b), a.dot(b));
}

std::array<Vec2, 3> turning_angle_gradient(const CortexState& c, std::size_t i) {
  const Vec2 before = direction_gradient(c.x[i] - c.x[c.previous(i)]);
  const Vec2 after = direction_gradient(c.x[c.next(i)] - c.x[i]);
  return {before, -(before + after), after};
}

double bending_energy(const CortexState& c, const CellParameters& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double bend = turning_angle(c, i) - rest_angle(c);
    sum += 0.5 * p.bending_stiffness * bend * bend;
  }
  return sum;
}

void add_bending(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A) {
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::array<Vec2, 3> g = turning_angle_gradient(c, i);
    const double moment = p.bending_stiffness * (turning_angle(c, i) - rest_angle(c));
    const std::uint32_t before = first + static_cast<std::uint32_t>(c.previous(i));
    const std::uint32_t here = first + static_cast<std::uint32_t>(i);
    const std::uint32_t after = first + static_cast<std::uint32_t>(c.next(i));
    force[before] -= moment * g[0];
    force[here] -= moment * g[1];
    force[after] -= moment * g[2];
    A.directed.add(dt * p.bending_stiffness, {{before, g[0]}, {here, g[1]}, {after, g[2]}});
  }
}

} // namespace matrigrate
