#include "observe/cell_scene.hpp"

#include "cell/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace matrigrate::io {

namespace {

/// The part of a polygon that lies ahead of a line, along a direction (Sutherland and Hodgman 1974).
/// @param ahead  of the origin along the direction, where the line lies [um]
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& direction, double ahead) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double past_a = a.dot(direction) - ahead;
    const double past_b = b.dot(direction) - ahead;
    if (past_a >= 0.0) kept.push_back(a);
    if ((past_a >= 0.0) != (past_b >= 0.0)) kept.emplace_back(a + (past_a / (past_a - past_b)) * (b - a));
  }
  return kept;
}

/// The area ahead of the line that parts front particles from rear ones; all of it before the first protrusion.
std::vector<Vec2> front_area(const State& s) {
  if (!s.polarization || !s.has_cell()) return s.cortex.x;
  const Vec2 direction(std::cos(*s.polarization), std::sin(*s.polarization));
  const std::vector<std::uint8_t> in_front = front(s.cortex, *s.polarization);
  double front_least = std::numeric_limits<double>::infinity();
  double rear_most = -front_least;
  for (std::size_t i = 0; i < s.cortex.size(); ++i) {
    const double along = s.cortex.x[i].dot(direction);
    if (in_front[i] != 0)
      front_least = std::min(front_least, along);
    else
      rear_most = std::max(rear_most, along);
  }
  return clipped(s.cortex.x, direction, 0.5 * (front_least + rear_most));
}

std::optional<Vec2> anchor_of(const Phase& phase) {
  if (const auto* maturing = std::get_if<Maturing>(&phase)) return maturing->anchor;
  if (const auto* contracting = std::get_if<Contracting>(&phase)) return contracting->anchor;
  return std::nullopt;
}

} // namespace

std::size_t matrix_class(double f) {
  if (f >= 1.0) return 0;
  if (f <= 0.0) return matrix_classes - 1;
  return 1 + std::min(static_cast<std::size_t>((1.0 - f) * (matrix_classes - 2)), matrix_classes - 3);
}

CellScene cell_scene(const State& s, const Parameters& p, std::vector<Vec2> path) {
  CellScene scene;
  scene.t = s.t;
  scene.radius = p.ecm.radius;
  scene.spacing = p.ecm.particle_spacing;
  for (std::size_t i = 0; i < s.ecm.size(); ++i) scene.matrix[matrix_class(s.ecm.f[i])].push_back(s.ecm.x[i]);
  scene.cell = s.cortex.x;
  scene.front = front_area(s);
  for (const Protrusion& protrusion : s.protrusions) {
    DrawnProtrusion drawn{.phase = protrusion.phase.index(),
                          .contour = {},
                          .tip = s.cortex.x[protrusion.centre],
                          .anchor = anchor_of(protrusion.phase)};
    for (int k = -p.protrusion.half_width; k <= p.protrusion.half_width; ++k)
      drawn.contour.push_back(s.cortex.x[s.cortex.along(protrusion.centre, k)]);
    scene.protrusions.push_back(std::move(drawn));
  }
  scene.path = std::move(path);
  return scene;
}

Box whole_disc(const CellScene& scene) {
  const Vec2 half = Vec2::Constant(scene.radius + 0.5 * scene.spacing);
  return {-half, half};
}

Box surroundings(std::span<const CellScene> scenes, double room) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  const auto include = [&](const Vec2& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  };
  double radius = 0.0;
  for (const CellScene& scene : scenes) {
    radius = std::max(radius, scene.radius + 0.5 * scene.spacing);
    for (const Vec2& x : scene.cell) include(x);
    for (const Vec2& x : scene.path) include(x);
    for (const DrawnProtrusion& protrusion : scene.protrusions)
      if (protrusion.anchor) include(*protrusion.anchor);
  }
  if (!(low.x() <= high.x())) low = high = Vec2::Zero();
  const double half = std::min(0.5 * (high - low).maxCoeff() + room, radius);
  const Vec2 most = Vec2::Constant(radius - half);
  const Vec2 centre = (0.5 * (low + high)).cwiseMax(-most).cwiseMin(most);
  return {centre - Vec2::Constant(half), centre + Vec2::Constant(half)};
}

} // namespace matrigrate::io
