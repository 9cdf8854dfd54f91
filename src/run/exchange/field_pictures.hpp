#pragma once

#include "observe/frame.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// The fields of a frame as pictures: numbers on a square grid of pixels.
/// Test: tests/unit/exchange/ome_tiff_test.cpp
namespace matrigrate::exchange {

/// The square of pixels around the disc of matrix; its centre is that of the disc.
struct PixelGrid {
  double pixel = 1.0;   ///< width of a pixel [um]
  std::size_t side = 0; ///< pixels along each edge

  /// The least square of such pixels that holds the disc.
  static PixelGrid over(const observe::FrameHead& head, double pixel);

  /// Middle of a column along x, and of a row along y; the upper row is the first one [um].
  double x(std::size_t column) const { return (static_cast<double>(column) + 0.5) * pixel - 0.5 * width(); }
  double y(std::size_t row) const { return 0.5 * width() - (static_cast<double>(row) + 0.5) * pixel; }
  double width() const { return static_cast<double>(side) * pixel; }
};

/// A channel: a scalar of the matrix, a component of a vector, or the cells.
struct Channel {
  std::string name, unit; ///< "pressure", "Pa"
  /// The value of each particle; none of the cells.
  std::function<observe::Floats(const observe::Frame&)> values;
};

/// What the frames of a film hold: displacement_x, displacement_y, velocity_x, velocity_y, f_degr, pressure, ...,
/// layers of the matrix, obstacle, and last `cell`: the number of the cell that covers a pixel, else 0.
std::vector<Channel> channels(const observe::Film& film);

/// The particle nearest to the middle of each pixel, row by row from the upper left; no_particle beyond the disc.
inline constexpr std::size_t no_particle = static_cast<std::size_t>(-1);
std::vector<std::size_t> nearest_particles(const observe::FrameHead& head, const observe::Frame& frame,
                                           const PixelGrid& grid);

/// A channel: the value of the nearest particle, NaN beyond the disc.
std::vector<float> picture(const Channel& channel, const observe::Frame& frame, const PixelGrid& grid,
                           const std::vector<std::size_t>& nearest);

} // namespace matrigrate::exchange
