#pragma once

#include "ecm/loop/fibres.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <string>

/// Snapshots of fields of the matrix, with the outlines of the cells; fluid is grey.
/// Test: tests/unit/draw/layer_picture_test.cpp
namespace matrigrate::draw {

/// Displacement of the solid: its magnitude in colour, arrows at every third particle along either axis.
/// @return the SVG document
std::string displacement_picture(const State& s, const Parameters& p);

/// Von Mises stress of the fibres (Heck et al. 2020, Eq. (11) and Fig 13).   @return the SVG document
std::string fibre_stress_picture(const State& s, const Parameters& p, const FibreNetwork& network);

} // namespace matrigrate::draw
