#pragma once

#include "tracks/read_tracks.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// Square displacements of measured and of simulated cells. Test: tests/unit/tracks/readouts_test.cpp
namespace matrigrate::tracks {

/// Over all pairs of positions, at lags of 1, 2, ... intervals.
struct Displacements {
  std::vector<double> squares; ///< sum [um^2]
  std::vector<double> pairs;   ///< how many
};

/// @param longest  lag
Displacements displacements(const Track& track, std::size_t longest);

/// Slope of log y over log x by least squares, of the points whose y is above 0. NaN of fewer than `least` of them.
double log_slope(std::span<const double> x, std::span<const double> y, std::size_t least);

} // namespace matrigrate::tracks
