#pragma once

#include "base/vector.hpp"

#include <string>
#include <vector>

/// Pictures as self-contained SVG text: light background, colour-blind-safe colours, dark text. Nothing here knows
/// physics. Equal input gives equal bytes in every locale. Test: tests/unit/draw/draw_test.cpp
namespace matrigrate::draw {

/// A finished picture.
struct Picture {
  std::string name;    ///< file name without ending
  std::string caption; ///< one or two sentences for the report
  std::string svg;     ///< the whole SVG document
};

/// Particles in the plane coloured by a scalar, with a colour bar and a scale bar.
struct ParticlePicture {
  std::string title;
  std::string value_label;                 ///< with unit: "displacement (µm)"
  std::vector<Vec2> position = {};         ///< [um]; a particle whose position is not finite is left out
  std::vector<double> value = {};          ///< one a particle; grey where not finite
  double particle_size = 2.0;              ///< side of the square that a particle takes [um]
  double value_min = 0.0, value_max = 0.0; ///< range of the colour bar; taken from the values if both are 0; values
                                           ///< beyond it get the colour of its end
  std::vector<std::vector<Vec2>> outlines = {}; ///< closed curves on top of the particles [um]
};

/// @param width  [pixel] at least 240; the height follows from the extent of the particles
/// @return  the SVG document; compact: coordinates rounded to 0.1 pixel, one group a colour level
/// @throws std::invalid_argument if the arrays differ in length, particle_size is not positive, the range of the colour
///         bar is empty or the drawing is too small
std::string to_svg(const ParticlePicture& picture, int width = 640);

} // namespace matrigrate::draw
