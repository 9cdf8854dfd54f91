#include "draw/frame_scene.hpp"

#include <cmath>
#include <utility>

namespace matrigrate::draw {

namespace {

std::vector<Vec2> vectors(const observe::Floats& x) {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) all.emplace_back(x[i], x[i + 1]);
  return all;
}

/// The stretch of a cell's outline that belongs to a protrusion, from one end to the other.
/// @param first  index of the cell's first particle in the outlines of all cells
std::vector<Vec2> contour(const std::vector<Vec2>& outline, const observe::Bytes& protrusion, std::size_t first,
                          std::size_t which) {
  const std::size_t n = outline.size();
  const auto belongs = [&](std::size_t i) { return protrusion[first + i % n] == which; };
  std::size_t begin = 0;
  while (begin < n && belongs(begin)) ++begin; // outside of it
  std::vector<Vec2> stretch;
  for (std::size_t i = begin; i < begin + n; ++i)
    if (belongs(i)) stretch.push_back(outline[i % n]);
  return stretch;
}

} // namespace

std::vector<Vec2> matrix_positions(const observe::FrameHead& head, const observe::Frame& frame) {
  std::vector<Vec2> x = vectors(frame.matrix.displacement);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += Vec2(head.reference[2 * i], head.reference[2 * i + 1]);
  return x;
}

observe::CellScene frame_scene(const observe::FrameHead& head, const observe::Frame& frame,
                               std::vector<std::vector<Vec2>> paths) {
  observe::CellScene scene;
  scene.t = frame.t;
  scene.radius = head.radius;
  scene.spacing = head.spacing;
  const std::vector<Vec2> x = matrix_positions(head, frame);
  const observe::Bytes& obstacle = head.obstacle;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool rigid = !obstacle.empty() && obstacle[i] != 0;
    (rigid ? scene.obstacles : scene.matrix[observe::matrix_class(frame.matrix.f_degr[i])]).push_back(x[i]);
  }
  const std::vector<Vec2> outlines = vectors(frame.outline.x);
  const std::vector<std::size_t> ends = observe::outline_ends(frame.outline);
  const std::vector<std::vector<Vec2>> nuclei = observe::nuclei_of(frame);
  const observe::ProtrusionFrame& p = frame.protrusions;
  paths.resize(ends.size());
  for (std::size_t c = 0; c < ends.size(); ++c) {
    const std::size_t first = c == 0 ? 0 : ends[c - 1];
    observe::DrawnCell& cell = scene.cells.emplace_back();
    cell.path = std::move(paths[c]);
    if (!nuclei.empty()) cell.nucleus = nuclei[c];
    for (std::size_t i = first; i < ends[c]; ++i) {
      cell.outline.push_back(outlines[i]);
      if (frame.outline.front[i] != 0) cell.front.push_back(outlines[i]);
    }
    for (std::size_t k = 0; k < p.id.size(); ++k) {
      if (!p.cell.empty() && p.cell[k] != frame.outline.cell[first]) continue;
      const Vec2 anchor(p.anchor[2 * k], p.anchor[2 * k + 1]);
      scene.protrusions.push_back({.phase = p.phase[k],
                                   .contour = contour(cell.outline, frame.outline.protrusion, first, k),
                                   .tip = cell.outline[static_cast<std::size_t>(p.centre[k])],
                                   .anchor = anchor.allFinite() ? std::optional<Vec2>(anchor) : std::nullopt});
    }
  }
  return scene;
}

} // namespace matrigrate::draw
