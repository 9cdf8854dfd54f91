#pragma once

#include "observe/tracks.hpp"

#include <span>
#include <vector>

/// How the cell spreads and in which direction. Test: tests/unit/observe/displacement_statistics_test.cpp
namespace matrigrate {

/// Mean square displacement at one lag.
struct MsdPoint {
  double lag = 0.0;        ///< [s]
  double msd = 0.0;        ///< mean over all start times, overlapping [um^2]
  std::size_t samples = 0; ///< start times
};

/// Mean square displacement of the centre of mass (Heck et al. 2020, section on the number of protrusions), at lags of
/// 1, 2, 3 ... intervals up to half of the time; empty where the rows do not fall on multiples of the interval.
/// @param interval  [s]
std::vector<MsdPoint> mean_square_displacement(std::span<const TrackRow> rows, double interval);

/// Slope of log MSD over log lag by least squares: 1 for a random walk, 2 for a straight path. NaN with fewer than
/// three lags [-].
double msd_slope(std::span<const MsdPoint> points);

/// Mean angle between the path and a direction taken without sign, each step of `interval` weighted by its length: 0
/// along, 90 across, 45 on average where all directions in the plane are equally likely
/// [degrees]. NaN without a path.
/// @param direction  angle of the fibres [rad]   @param interval  [s]
double angle_to(std::span<const TrackRow> rows, double direction, double interval);

} // namespace matrigrate
