#include "draw/tunnel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace matrigrate::draw {

namespace {

constexpr double reach = 2.0;       ///< of the average, over the spacing
constexpr double fineness = 0.5;    ///< step of the lattice over the spacing
constexpr double largest_gap = 8.0; ///< area of a hole that is closed, over that of a particle

/// Middle of 1 - f_degr in a class.
double degraded_share(std::size_t c) {
  if (c == 0) return 0.0;
  if (c == observe::matrix_classes - 1) return 1.0;
  return (static_cast<double>(c) - 0.5) / (observe::matrix_classes - 2);
}

bool near(const Vec2& x, const observe::Box& box, double margin) {
  return x.allFinite() && (x.array() > box.low.array() - margin).all() && (x.array() < box.high.array() + margin).all();
}

/// Nodes around the degraded particles that are seen; fewer than two a side if there are none.
Lattice lattice_around(const observe::CellScene& scene, const observe::Box& seen) {
  const double margin = reach * scene.spacing;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (std::size_t c = 1; c < observe::matrix_classes; ++c)
    for (const Vec2& x : scene.matrix[c])
      if (near(x, seen, margin)) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
      }
  Lattice lattice{.low = low - Vec2::Constant(margin), .step = fineness * scene.spacing};
  if (!(low.x() <= high.x())) return lattice;
  const auto nodes = [&](double length) { return static_cast<std::size_t>(std::ceil(length / lattice.step)) + 1; };
  lattice.nx = nodes(high.x() - low.x() + 2.0 * margin);
  lattice.ny = nodes(high.y() - low.y() + 2.0 * margin);
  lattice.value.assign(lattice.nx * lattice.ny, 0.0);
  return lattice;
}

/// Adds a share around a particle, weighted by (1 - q^2)^2 with q the distance over the reach; on a regular lattice the
/// sum of weights is 1.
void spread(double share, const Vec2& x, double spacing, Lattice& lattice) {
  const double radius = reach * spacing;
  const double weight = share * 3.0 / (std::numbers::pi * reach * reach);
  const Vec2 first = (x - lattice.low - Vec2::Constant(radius)) / lattice.step;
  const Vec2 last = (x - lattice.low + Vec2::Constant(radius)) / lattice.step;
  const auto end = [](double node, std::size_t n) {
    return std::min(static_cast<std::size_t>(std::max(0.0, node)) + 1, n);
  };
  for (auto j = static_cast<std::size_t>(std::max(0.0, std::ceil(first.y()))); j < end(last.y(), lattice.ny); ++j)
    for (auto i = static_cast<std::size_t>(std::max(0.0, std::ceil(first.x()))); i < end(last.x(), lattice.nx); ++i) {
      const double q2 = (lattice.place(i, j) - x).squaredNorm() / (radius * radius);
      if (q2 < 1.0) lattice.value[j * lattice.nx + i] += weight * (1.0 - q2) * (1.0 - q2);
    }
}

} // namespace

std::vector<Curve> degraded_edges(const observe::CellScene& scene, const observe::Box& seen) {
  Lattice lattice = lattice_around(scene, seen);
  if (lattice.nx < 2) return {};
  for (std::size_t c = 1; c < observe::matrix_classes; ++c)
    for (const Vec2& x : scene.matrix[c])
      if (near(x, seen, reach * scene.spacing)) spread(degraded_share(c), x, scene.spacing, lattice);
  std::vector<Curve> edges = contours(lattice, 0.5);
  const double gap = largest_gap * scene.spacing * scene.spacing;
  std::erase_if(edges, [&](const Curve& edge) { return enclosed(edge) < 0.0 && enclosed(edge) > -gap; });
  return edges;
}

} // namespace matrigrate::draw
