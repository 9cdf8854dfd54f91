#pragma once

#include "draw/colour.hpp"
#include "observe/cell_scene.hpp"

#include <span>
#include <string>
#include <vector>

/// Figures for a publication: a few moments of a run side by side. Test: tests/unit/draw/figure_panel_test.cpp
namespace matrigrate::draw {

/// Values of the matrix at the moments of a figure, and the colours of all of them.
struct FigureField {
  std::string label; ///< with unit: "displacement [um]"
  ColourMap map = ColourMap::sequential;
  double low = 0.0, high = 1.0;            ///< ends of the colour bar; values beyond them get the colour of the end
  std::vector<std::vector<Vec2>> position; ///< of the particles at each moment [um]
  std::vector<std::vector<double>> value;  ///< of each particle; NaN in the fluid
};

/// Scenes side by side, up to four in a row, at one scale and place, with their times, a scale bar, a legend and, for a
/// field, one colour bar.
/// @param field  null: the matrix is coloured by how intact it is
/// @return  the SVG document
/// @throws std::invalid_argument if there is no scene, or the field is of another number of moments or particles
std::string figure_panel(std::span<const observe::CellScene> scenes, const FigureField* field);

} // namespace matrigrate::draw
