#include "observe/displacement_statistics.hpp"

#include "observe/readouts.hpp"
#include "tracks/displacements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace matrigrate {

namespace {

/// Centres at multiples of the interval from the first row on; empty if one of them is missing in between.
std::vector<Vec2> sampled(std::span<const TrackRow> rows, double interval) {
  std::vector<Vec2> centres;
  const double tolerance = 1e-6 * interval;
  for (const TrackRow& row : rows) {
    const double next = rows.front().t + interval * static_cast<double>(centres.size());
    if (row.t < next - tolerance) continue;
    if (row.t > next + tolerance) return {};
    centres.push_back(row.centre);
  }
  return centres;
}

} // namespace

std::vector<MsdPoint> mean_square_displacement(std::span<const TrackRow> rows, double interval) {
  tracks::Track track;
  for (const Vec2& x : sampled(rows, interval)) {
    track.k.push_back(track.k.size());
    track.x.push_back(x.x());
    track.y.push_back(x.y());
  }
  const tracks::Displacements found = tracks::displacements(track, track.span() / 2);
  std::vector<MsdPoint> points;
  for (std::size_t k = 0; k < found.squares.size(); ++k)
    points.push_back({.lag = interval * static_cast<double>(k + 1),
                      .msd = found.squares[k] / found.pairs[k],
                      .samples = static_cast<std::size_t>(found.pairs[k])});
  return points;
}

double msd_slope(std::span<const MsdPoint> points) {
  std::vector<double> lags, squares;
  for (const MsdPoint& point : points) {
    lags.push_back(point.lag);
    squares.push_back(point.msd);
  }
  return tracks::log_slope(lags, squares, 3);
}

double angle_to(std::span<const TrackRow> rows, double direction, double interval) {
  const std::vector<Vec2> x = sampled(rows, interval);
  const Vec2 d(std::cos(direction), std::sin(direction));
  double sum = 0.0;
  double length = 0.0;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Vec2 step = x[k] - x[k - 1];
    sum += step.norm() * std::atan2(std::abs(cross(d, step)), std::abs(d.dot(step)));
    length += step.norm();
  }
  return length > 0.0 ? sum / length * 180.0 / std::numbers::pi : undefined;
}

} // namespace matrigrate
