#include "cell/repulsion.hpp"

#include "base/points_in.hpp"
#include "cell/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

constexpr std::size_t nearest_partner = 3; // particles along the ring

struct Touch {
  std::size_t particle;
  std::size_t segment;
  double s;
  double d;
  Vec2 n; // from the segment to the particle
};

/// Marks the segments whose middle is within its limit of a point.
MATRIGRATE_SIMD
void mark_close(const Vec2& a, std::span<const double> x, std::span<const double> y, std::span<const double> limit2,
                std::span<std::uint8_t> close) {
  const double ax = a.x(), ay = a.y();
  for (std::size_t j = 0; j < close.size(); ++j) {
    const double dx = x[j] - ax, dy = y[j] - ay;
    close[j] = dx * dx + dy * dy < limit2[j] ? 1 : 0;
  }
}

std::vector<Touch> touches(const CortexState& c, double reach) {
  const std::size_t n = c.size();
  std::vector<double> x(n), y(n), limit2(n); // of the middles of segments
  for (std::size_t j = 0; j < n; ++j) {
    const Vec2 e = c.x[c.next(j)] - c.x[j];
    x[j] = c.x[j].x() + 0.5 * e.x();
    y[j] = c.x[j].y() + 0.5 * e.y();
    limit2[j] = std::pow(0.5 * e.norm() + reach, 2);
  }
  std::vector<std::uint8_t> close(n);
  std::vector<Touch> found;
  for (std::size_t i = 0; i < n; ++i) {
    mark_close(c.x[i], x, y, limit2, close);
    for (std::size_t j = next_marked(close, 0); j < n; j = next_marked(close, j + 1)) {
      if (c.apart(i, j) < nearest_partner || c.apart(i, c.next(j)) < nearest_partner) continue;
      const ClosestPoint q = closest_point(c.x[i], c.x[j], c.x[c.next(j)]);
      const double d = q.from.norm();
      if (d >= reach || d <= 0.0) continue;
      found.push_back({i, j, q.s, d, q.from / d});
    }
  }
  return found;
}

/// What keeps two sides from passing through each other.
struct Wall {
  explicit Wall(const CellParameters& p)
      : reach(0.5 * p.repulsion_distance), force(p.repulsion_stiffness * std::pow(reach, 1.5)) {}
  double reach; // [um]
  double force; // [nN]
};

/// Minus the derivative of repulsion(), d < d_rep [nN/um].
double slope(double d, const CellParameters& p) {
  const double hertz = 1.5 * p.repulsion_stiffness * std::sqrt(p.repulsion_distance - d);
  const Wall wall(p);
  return d < wall.reach ? hertz + wall.force * wall.reach / (d * d) : hertz;
}

} // namespace

double repulsion(double d, const CellParameters& p) {
  if (d >= p.repulsion_distance) return 0.0;
  const double hertz = p.repulsion_stiffness * std::pow(p.repulsion_distance - d, 1.5);
  const Wall wall(p);
  return d < wall.reach ? hertz + wall.force * (wall.reach / d - 1.0) : hertz;
}

double repulsion_energy(const CortexState& c, const CellParameters& p) {
  const Wall wall(p);
  double sum = 0.0;
  for (const Touch& t : touches(c, p.repulsion_distance)) {
    sum += p.repulsion_stiffness / 2.5 * std::pow(p.repulsion_distance - t.d, 2.5);
    if (t.d < wall.reach) sum += wall.force * (wall.reach * std::log(wall.reach / t.d) - (wall.reach - t.d));
  }
  return sum;
}

void add_repulsion(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                   DragSystem& A) {
  for (const Touch& t : touches(c, p.repulsion_distance)) {
    const std::uint32_t i = first + static_cast<std::uint32_t>(t.particle);
    const std::uint32_t a = first + static_cast<std::uint32_t>(t.segment);
    const std::uint32_t b = first + static_cast<std::uint32_t>(c.next(t.segment));
    const Vec2 f = repulsion(t.d, p) * t.n;
    force[i] += f;
    force[a] -= (1.0 - t.s) * f;
    force[b] -= t.s * f;
    A.directed.add(dt * slope(t.d, p), {{i, t.n}, {a, -(1.0 - t.s) * t.n}, {b, -t.s * t.n}});
  }
}

} // namespace matrigrate
