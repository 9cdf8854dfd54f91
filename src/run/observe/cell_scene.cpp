#include "observe/cell_scene.hpp"

#include "cell/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace matrigrate::observe {

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
std::vector<Vec2> front_area(const Cell& cell) {
  if (!cell.polarization) return cell.cortex.x;
  const Vec2 direction(std::cos(*cell.polarization), std::sin(*cell.polarization));
  const std::vector<std::uint8_t> in_front = front(cell.cortex, *cell.polarization);
  double front_least = std::numeric_limits<double>::infinity();
  double rear_most = -front_least;
  for (std::size_t i = 0; i < cell.cortex.size(); ++i) {
    const double along = cell.cortex.x[i].dot(direction);
    if (in_front[i] != 0)
      front_least = std::min(front_least, along);
    else
      rear_most = std::max(rear_most, along);
  }
  return clipped(cell.cortex.x, direction, 0.5 * (front_least + rear_most));
}

std::optional<Vec2> anchor_of(const Phase& phase) {
  if (const auto* maturing = std::get_if<Maturing>(&phase)) return maturing->anchor;
  if (const auto* contracting = std::get_if<Contracting>(&phase)) return contracting->anchor;
  return std::nullopt;
}

DrawnProtrusion drawn(const Cell& cell, const Protrusion& protrusion, const Parameters& p) {
  DrawnProtrusion drawn{.phase = protrusion.phase.index(),
                        .contour = {},
                        .tip = cell.cortex.x[protrusion.centre],
                        .anchor = anchor_of(protrusion.phase)};
  for (int k = -p.protrusion.half_width; k <= p.protrusion.half_width; ++k)
    drawn.contour.push_back(cell.cortex.x[cell.cortex.along(protrusion.centre, k)]);
  return drawn;
}

} // namespace

std::size_t matrix_class(double f) {
  if (f >= 1.0) return 0;
  if (f <= 0.0) return matrix_classes - 1;
  return 1 + std::min(static_cast<std::size_t>((1.0 - f) * (matrix_classes - 2)), matrix_classes - 3);
}

std::vector<std::vector<Vec2>> paths_so_far(const State& s, std::span<const TrackRow> rows) {
  std::vector<std::vector<Vec2>> paths;
  for (const Cell& cell : s.cells) {
    std::vector<Vec2>& path = paths.emplace_back();
    for (const TrackRow& row : rows)
      if (row.cell == cell.id) path.push_back(row.centre);
    if (rows.empty() || rows.back().step != s.step) path.push_back(centre_of_mass(cell.cortex));
  }
  return paths;
}

CellScene cell_scene(const State& s, const Parameters& p, std::vector<std::vector<Vec2>> paths) {
  CellScene scene;
  scene.t = s.t;
  scene.radius = p.ecm.radius;
  scene.spacing = p.ecm.particle_spacing;
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    (s.ecm.in_obstacle(i) ? scene.obstacles : scene.matrix[matrix_class(s.ecm.f[i])]).push_back(s.ecm.x[i]);
  paths.resize(s.cells.size());
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    const Cell& cell = s.cells[k];
    scene.cells.push_back(
        {.outline = cell.cortex.x, .front = front_area(cell), .path = std::move(paths[k]), .nucleus = cell.nucleus.x});
    for (const Protrusion& protrusion : cell.protrusions) scene.protrusions.push_back(drawn(cell, protrusion, p));
  }
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
    for (const DrawnCell& cell : scene.cells) {
      for (const Vec2& x : cell.outline) include(x);
      for (const Vec2& x : cell.path) include(x);
    }
    for (const DrawnProtrusion& protrusion : scene.protrusions)
      if (protrusion.anchor) include(*protrusion.anchor);
  }
  if (!(low.x() <= high.x())) low = high = Vec2::Zero();
  const double half = std::min(0.5 * (high - low).maxCoeff() + room, radius);
  const Vec2 most = Vec2::Constant(radius - half);
  const Vec2 centre = (0.5 * (low + high)).cwiseMax(-most).cwiseMin(most);
  return {centre - Vec2::Constant(half), centre + Vec2::Constant(half)};
}

} // namespace matrigrate::observe
