#include "observe/displacement_statistics.hpp"

#include "observe/readouts.hpp"

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
  const std::vector<Vec2> x = sampled(rows, interval);
  std::vector<MsdPoint> points;
  for (std::size_t lag = 1; 2 * lag < x.size(); ++lag) {
    MsdPoint point{.lag = interval * static_cast<double>(lag), .msd = 0.0, .samples = x.size() - lag};
    for (std::size_t k = 0; k < point.samples; ++k) point.msd += (x[k + lag] - x[k]).squaredNorm();
    point.msd /= static_cast<double>(point.samples);
    points.push_back(point);
  }
  return points;
}

double msd_slope(std::span<const MsdPoint> points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const MsdPoint& point : points) {
    if (!(point.msd > 0.0)) continue;
    const double a = std::log(point.lag);
    const double b = std::log(point.msd);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return n < 3.0 ? undefined : (n * xy - x * y) / (n * xx - x * x);
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
