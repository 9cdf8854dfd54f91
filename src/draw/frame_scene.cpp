#include "draw/frame_scene.hpp"

#include <cmath>
#include <utility>

namespace matrigrate::io {

namespace {

std::vector<Vec2> vectors(const Floats& x) {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) all.emplace_back(x[i], x[i + 1]);
  return all;
}

/// The stretch of the outline that belongs to a protrusion, from one end to the other.
std::vector<Vec2> contour(const std::vector<Vec2>& cell, const Bytes& protrusion, std::size_t which) {
  const std::size_t n = cell.size();
  const auto belongs = [&](std::size_t i) { return protrusion[i % n] == which; };
  std::size_t begin = 0;
  while (begin < n && belongs(begin)) ++begin; // outside of it
  std::vector<Vec2> stretch;
  for (std::size_t i = begin; i < begin + n; ++i)
    if (belongs(i)) stretch.push_back(cell[i % n]);
  return stretch;
}

} // namespace

std::vector<Vec2> matrix_positions(const FrameHead& head, const Frame& frame) {
  std::vector<Vec2> x = vectors(frame.matrix.displacement);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += Vec2(head.reference[2 * i], head.reference[2 * i + 1]);
  return x;
}

CellScene frame_scene(const FrameHead& head, const Frame& frame, std::vector<Vec2> path) {
  CellScene scene;
  scene.t = frame.t;
  scene.radius = head.radius;
  scene.spacing = head.spacing;
  const std::vector<Vec2> x = matrix_positions(head, frame);
  for (std::size_t i = 0; i < x.size(); ++i) scene.matrix[matrix_class(frame.matrix.f_degr[i])].push_back(x[i]);
  scene.cell = vectors(frame.outline.x);
  for (std::size_t i = 0; i < scene.cell.size(); ++i)
    if (frame.outline.front[i] != 0) scene.front.push_back(scene.cell[i]);
  const ProtrusionFrame& p = frame.protrusions;
  for (std::size_t k = 0; k < p.id.size(); ++k) {
    const Vec2 anchor(p.anchor[2 * k], p.anchor[2 * k + 1]);
    scene.protrusions.push_back({.phase = p.phase[k],
                                 .contour = contour(scene.cell, frame.outline.protrusion, k),
                                 .tip = scene.cell[static_cast<std::size_t>(p.centre[k])],
                                 .anchor = anchor.allFinite() ? std::optional<Vec2>(anchor) : std::nullopt});
  }
  scene.path = std::move(path);
  return scene;
}

} // namespace matrigrate::io
