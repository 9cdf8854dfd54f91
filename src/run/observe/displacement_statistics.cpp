#include "observe/displacement_statistics.hpp"

#include "tracks/read_tracks.hpp"

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

Guidance guidance(std::span<const TrackRow> rows, double direction, double interval) {
  Guidance found;
  const std::vector<Vec2> x = sampled(rows, interval);
  if (x.empty()) return found;
  const Vec2 d(std::cos(direction), std::sin(direction));
  const auto angle = [&](const Vec2& step) {
    return std::atan2(std::abs(cross(d, step)), std::abs(d.dot(step))) * 180.0 / std::numbers::pi;
  };
  double sum = 0.0, weighted = 0.0, length = 0.0, steps = 0.0;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const Vec2 step = x[k] - x[k - 1];
    if (!(step.norm() > 0.0)) continue;
    weighted += step.norm() * angle(step);
    length += step.norm();
    sum += angle(step);
    steps += 1.0;
  }
  if (length > 0.0) {
    found.path_angle = weighted / length;
    found.step_angle = sum / steps;
  }
  const Vec2 net = rows.back().centre - rows.front().centre;
  if (net.norm() > 0.0) found.net_angle = angle(net);
  for (std::size_t k = 0; k < found.ratios.size(); ++k) {
    constexpr std::array lags{3600.0, 10800.0, 21600.0}; // [s]
    const auto lag = static_cast<std::size_t>(std::llround(lags[k] / interval));
    double along = 0.0, across = 0.0;
    for (std::size_t i = 0; i + lag < x.size(); ++i) {
      const Vec2 step = x[i + lag] - x[i];
      along += d.dot(step) * d.dot(step);
      across += cross(d, step) * cross(d, step);
    }
    if (across > 0.0) found.ratios[k] = along / across;
  }
  return found;
}

} // namespace matrigrate
