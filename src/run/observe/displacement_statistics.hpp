#pragma once

#include "observe/tracks.hpp"

#include <array>
#include <span>
#include <vector>

/// How the cell spreads and in which direction. Test: tests/unit/observe/motion_test.cpp
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

/// How a path runs to a direction taken without sign, as that of fibres. Angles: 0 along, 90 across, 45 on average
/// where all directions in the plane are equally likely [degrees]; NaN without a path.
struct Guidance {
  double path_angle = undefined; ///< mean over the steps, each weighted by its length
  double step_angle = undefined; ///< mean over the steps, each counted alike
  double net_angle = undefined;  ///< of the displacement from start to end
  /// Mean square displacement along the direction over that across it, at lags of 1, 3 and 6 h, each over all start
  /// times, overlapping; 1 where the path has no direction; NaN of a shorter path, and where it never goes across [-].
  /// Of several runs, add up the squares first: the mean of ratios is ruled by the runs that hardly go across.
  std::array<double, 3> ratios{undefined, undefined, undefined};
};

/// @param direction  angle of the fibres [rad]   @param interval  of the steps [s]
Guidance guidance(std::span<const TrackRow> rows, double direction, double interval);

} // namespace matrigrate
