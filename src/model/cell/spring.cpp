#include "cell/spring.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr double shortest = 1e-3; // of l_c: bounds the force on a segment that a step has all but closed

double crowding_length(const CellParameters& p) { return p.crowding * initial_segment_length(p); }

/// Derivative of crowding_tension with respect to l [nN/um].
double crowding_stiffness(double l, const CellParameters& p) {
  const double ratio = crowding_length(p) / std::max(l, shortest * crowding_length(p));
  return ratio > 1.0 ? p.spring_stiffness * ratio * ratio : 0.0;
}

struct Segment {
  std::uint32_t a, b; // nodes
  double l;           // [um]
  Vec2 t;             // unit vector from a to b
};

Segment segment(const CortexState& c, std::size_t i, std::uint32_t first) {
  const std::size_t j = c.next(i);
  const Vec2 e = c.x[j] - c.x[i];
  const double l = e.norm();
  const Vec2 t = l > 0.0 ? Vec2(e / l) : Vec2::Zero();
  return {first + static_cast<std::uint32_t>(i), first + static_cast<std::uint32_t>(j), l, t};
}

void pull(const Segment& s, double T, double dt, std::span<Vec2> force, DragSystem& A) {
  force[s.a] += T * s.t;
  force[s.b] -= T * s.t;
  if (T <= 0.0 || dt <= 0.0 || s.l <= 0.0) return;
  const Vec2 n = perpendicular(s.t);
  A.directed.add(dt * T / s.l, {{s.a, n}, {s.b, -n}});
}

} // namespace

double crowding_tension(double l, const CellParameters& p) {
  const double l_c = crowding_length(p);
  return l < l_c ? -p.spring_stiffness * l_c * (l_c / std::max(l, shortest * l_c) - 1.0) : 0.0;
}

double crowding_energy(const CortexState& c, const CellParameters& p) {
  const double l_c = crowding_length(p);
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double l = (c.x[c.next(i)] - c.x[i]).norm();
    if (l < l_c) sum += p.spring_stiffness * l_c * (l - l_c - l_c * std::log(l / l_c));
  }
  return sum;
}

double spring_energy(const CortexState& c, std::span<const double> k) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double stretch = (c.x[c.next(i)] - c.x[i]).norm() - c.l0[i];
    sum += 0.5 * k[i] * stretch * stretch;
  }
  return sum;
}

void add_springs(const CortexState& c, const CellParameters& p, std::span<const double> k, double dt,
                 std::uint32_t first, std::span<Vec2> force, DragSystem& A) {
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Segment s = segment(c, i, first);
    pull(s, spring_tension(k[i], s.l, c.l0[i]) + crowding_tension(s.l, p), dt, force, A);
    A.directed.add(p.dashpot + dt * (k[i] + crowding_stiffness(s.l, p)), {{s.a, s.t}, {s.b, -s.t}});
  }
}

void add_tension(const CortexState& c, std::size_t i, double T, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A) {
  pull(segment(c, i, first), T, dt, force, A);
}

void add_dashpot(const CortexState& c, std::size_t i, double drag, std::uint32_t first, DragSystem& A) {
  const Segment s = segment(c, i, first);
  A.directed.add(drag, {{s.a, s.t}, {s.b, -s.t}});
}

void ratchet_rest_lengths(CortexState& c, const CellParameters& p, std::span<const std::uint8_t> soft) {
  const double l0_init = initial_segment_length(p);
  for (std::size_t i = 0; i < c.size(); ++i)
    if (!soft[i]) c.l0[i] = ratcheted(c.l0[i], (c.x[c.next(i)] - c.x[i]).norm(), l0_init);
}

} // namespace matrigrate
