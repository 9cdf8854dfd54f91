#pragma once

#include "draw/contour.hpp"
#include "observe/cell_scene.hpp"

#include <vector>

/// The matrix that the cells have degraded, as areas. Test: tests/unit/draw/tunnel_test.cpp
namespace matrigrate::draw {

/// The edges of the degraded matrix: where the share that is degraded, 1 - f_degr, averaged over two spacings, is a
/// half. Gaps between particles of fluid that drift apart are closed.
/// @param seen  what lies outside is left out [um]
std::vector<Curve> degraded_edges(const observe::CellScene& scene, const observe::Box& seen);

} // namespace matrigrate::draw
