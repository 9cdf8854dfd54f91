#pragma once

#include "base/vector.hpp"
#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// What is drawn of a state, without the rest. Test: tests/unit/draw/cell_picture_test.cpp
namespace matrigrate::observe {

/// Matrix particles are drawn in classes of f_degr: intact, three between, fluid.
inline constexpr std::size_t matrix_classes = 5;

/// Class of a degree of intactness: 0 only for the intact, the last one only for fluid.
std::size_t matrix_class(double f);

/// A protrusion: the stretch of the cortex that belongs to it, and its adhesion.
struct DrawnProtrusion {
  std::size_t phase = 0;      ///< index of the phase
  std::vector<Vec2> contour;  ///< [um]
  Vec2 tip = Vec2::Zero();    ///< [um]
  std::optional<Vec2> anchor; ///< [um]
};

struct DrawnCell {
  std::vector<Vec2> outline;   ///< the cortex [um]
  std::vector<Vec2> front;     ///< the front half of its area [um]
  std::vector<Vec2> path;      ///< of its centre of mass so far [um]
  std::vector<Vec2> nucleus{}; ///< its outline; empty without one [um]
};

struct CellScene {
  double t = 0.0;                                       ///< [s]
  double radius = 0.0;                                  ///< of the disc [um]
  double spacing = 0.0;                                 ///< of the matrix particles [um]
  std::array<std::vector<Vec2>, matrix_classes> matrix; ///< particles of each class, intact ones first [um]
  std::vector<Vec2> obstacles;                          ///< particles of rigid obstacles, in no class [um]
  std::vector<DrawnCell> cells;
  std::vector<DrawnProtrusion> protrusions; ///< of all cells
};

/// The paths of the centres of mass of the cells up to now.
/// @param rows  of tracks so far; the moment itself may be among them
std::vector<std::vector<Vec2>> paths_so_far(const State& s, std::span<const TrackRow> rows);

/// @param paths  of the centre of mass of each cell so far; none: no paths [um]
CellScene cell_scene(const State& s, const Parameters& p, std::vector<std::vector<Vec2>> paths);

/// A box in the plane [um].
struct Box {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
  Vec2 size() const { return high - low; }
};

/// The whole disc.
Box whole_disc(const CellScene& scene);

/// The square around the cells, anchors and paths of all scenes, with some room, within the disc.
/// @param room  [um]
Box surroundings(std::span<const CellScene> scenes, double room);

} // namespace matrigrate::observe
