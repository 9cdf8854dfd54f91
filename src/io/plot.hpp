#pragma once

#include "base/vector.hpp"

#include <string>
#include <vector>

/// Figures as self-contained SVG text: light background, colour-blind-safe colours, dark text. Nothing here knows physics.
namespace matrigrate::io {

/// A finished picture.
struct Figure {
  std::string name;    ///< file name without ending
  std::string caption; ///< one or two sentences for the report
  std::string svg;     ///< the whole SVG document
};

enum class Mark { line, dashed, points };

/// A curve of a plot. x and y are of one length; values that are not finite break the line.
struct Series {
  std::string label; ///< legend entry; empty for none
  std::vector<double> x, y;
  Mark mark = Mark::line;
  int colour = -1; ///< index into the palette; -1 takes the next one
};

/// A plot of curves over linear or logarithmic axes, with ticks at round numbers and a legend.
struct Plot {
  std::string title;
  std::string x_label, y_label; ///< with unit: "time [s]"
  bool log_x = false, log_y = false;
  std::vector<Series> series;
};

/// @return the SVG document, width x height pixels
std::string to_svg(const Plot& plot, int width = 720, int height = 460);

/// Particles in the plane coloured by a scalar, with a colour bar and a scale bar.
struct ParticlePicture {
  std::string title;
  std::string value_label; ///< with unit: "displacement [um]"
  std::vector<Vec2> position;  ///< [um]
  std::vector<double> value;   ///< one a particle
  double particle_size = 2.0;  ///< diameter of a dot [um]
  double value_min = 0.0, value_max = 0.0; ///< range of the colour bar; taken from the values if both are 0
  bool diverging = false;      ///< a map with a neutral middle, for signed values
  std::vector<Vec2> arrow;     ///< drawn from each particle if not empty [um]
  double arrow_scale = 1.0;    ///< length of an arrow over its vector
};

/// @return the SVG document; compact: coordinates rounded to 0.1 pixel, one group a colour level
std::string to_svg(const ParticlePicture& picture, int width = 720);

} // namespace matrigrate::io
