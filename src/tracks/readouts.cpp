#include "tracks/readouts.hpp"

#include "statistics/sample.hpp"
#include "tracks/read_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace matrigrate::tracks {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t window = 10;     ///< intervals of the directionality ratio
constexpr std::uint64_t draws_key = 1; ///< of the bootstrap

using statistics::mean_of_defined;

/// A track with a value for each interval, NaN in gaps.
struct Dense {
  std::vector<double> x, y;

  explicit Dense(const Track& track) : x(track.span() + 1, nan), y(track.span() + 1, nan) {
    for (std::size_t i = 0; i < track.k.size(); ++i) {
      x[track.k[i]] = track.x[i];
      y[track.k[i]] = track.y[i];
    }
  }
  std::size_t size() const { return x.size(); }
  double distance(std::size_t a, std::size_t b) const { return std::hypot(x[b] - x[a], y[b] - y[a]); }
};

std::vector<double> step_lengths(const Dense& at) {
  std::vector<double> lengths;
  for (std::size_t k = 1; k < at.size(); ++k) lengths.push_back(at.distance(k - 1, k));
  return lengths;
}

/// Distance over path of all windows without a gap: mean.
double windowed_ratio(const Dense& at, const std::vector<double>& lengths) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k + window < at.size(); ++k) {
    const double path = std::accumulate(lengths.begin() + static_cast<std::ptrdiff_t>(k),
                                        lengths.begin() + static_cast<std::ptrdiff_t>(k + window), 0.0);
    ratios.push_back(path > 0.0 ? at.distance(k, k + window) / path : nan);
  }
  return mean_of_defined(ratios);
}

/// Distance from start to end over the path; a gap counts as a straight step.
double whole_ratio(const Track& track) {
  double path = 0.0;
  for (std::size_t i = 1; i < track.k.size(); ++i)
    path += std::hypot(track.x[i] - track.x[i - 1], track.y[i] - track.y[i - 1]);
  return path > 0.0 ? std::hypot(track.x.back() - track.x.front(), track.y.back() - track.y.front()) / path : nan;
}

/// Larger over smaller eigenvalue of the sum of the squares of steps; NaN of fewer than three steps and of a line.
double anisotropy_of(const Dense& at) {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  std::size_t n = 0;
  for (std::size_t k = 1; k < at.size(); ++k) {
    const double dx = at.x[k] - at.x[k - 1], dy = at.y[k] - at.y[k - 1];
    if (std::isnan(dx)) continue;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    ++n;
  }
  const double middle = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
  const double along = middle + radius, across = along > 0.0 ? (xx * yy - xy * xy) / along : 0.0;
  return n >= 3 && across > 1e-12 * along ? along / across : nan;
}

/// Mean turning angle [deg] and mean cosine; steps of length zero have no direction.
std::pair<double, double> turning(const Dense& at, const std::vector<double>& lengths) {
  std::vector<double> angles, cosines;
  for (std::size_t k = 1; k + 1 < at.size(); ++k) {
    if (!(lengths[k - 1] > 0.0 && lengths[k] > 0.0)) continue;
    const double ax = at.x[k] - at.x[k - 1], ay = at.y[k] - at.y[k - 1];
    const double bx = at.x[k + 1] - at.x[k], by = at.y[k + 1] - at.y[k];
    const double turn = std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    angles.push_back(std::abs(turn) * 180.0 / std::numbers::pi);
    cosines.push_back(std::cos(turn));
  }
  return {mean_of_defined(angles), mean_of_defined(cosines)};
}

/// Log-log slope over lags from first to last; NaN of fewer than two, and where one has no displacement.
double slope(const std::vector<double>& square, std::size_t first, std::size_t last) {
  std::vector<double> lags, squares;
  for (std::size_t lag = first; lag <= last && lag <= square.size(); ++lag)
    if (!std::isnan(square[lag - 1])) {
      if (!(square[lag - 1] > 0.0)) return nan;
      lags.push_back(static_cast<double>(lag));
      squares.push_back(square[lag - 1]);
    }
  return log_slope(lags, squares, 2);
}

/// Intervals until the mean ratio falls below one half, interpolated; NaN if it stays above, or begins below.
double half_time(const std::vector<double>& mean) {
  for (std::size_t k = 0; k < mean.size(); ++k)
    if (mean[k] < 0.5) return k == 0 ? nan : static_cast<double>(k) + (mean[k - 1] - 0.5) / (mean[k - 1] - mean[k]);
  return nan;
}

/// The mean square displacement at the shortest lag if the localisation error leaves nothing of it, else 0.
double buried_of(std::span<const double> square, double error) {
  const auto shortest = std::ranges::find_if(square, [](double one) { return !std::isnan(one); });
  return shortest != square.end() && *shortest > 0.0 && *shortest <= 4.0 * error * error ? *shortest : 0.0;
}

} // namespace

double persistence(std::span<const double> square, double interval) {
  std::vector<double> t, y;
  for (std::size_t k = 0; k < square.size(); ++k)
    if (!std::isnan(square[k])) {
      if (!(square[k] > 0.0)) return nan;
      t.push_back(interval * static_cast<double>(k + 1));
      y.push_back(square[k]);
    }
  if (t.size() < 3) return nan;
  constexpr int candidates = 400;
  const double low = interval / 4.0, high = 4.0 * t.back();
  double best = nan, least = std::numeric_limits<double>::infinity();
  for (int c = 0; c < candidates; ++c) {
    const double P = low * std::pow(high / low, static_cast<double>(c) / (candidates - 1));
    double sum = 0.0, squares = 0.0; // of the model over the data, up to the factor 2 S^2, which is fitted as well
    for (std::size_t i = 0; i < t.size(); ++i) {
      const double ratio = P * (t[i] + P * std::expm1(-t[i] / P)) / y[i];
      sum += ratio;
      squares += ratio * ratio;
    }
    const double misfit = static_cast<double>(t.size()) - sum * sum / squares;
    if (misfit >= least) continue;
    least = misfit;
    best = P;
  }
  return best >= interval / 2.0 && best <= t.back() ? best : nan;
}

TrackParts::TrackParts(const Tracks& tracks) : m_interval(tracks.interval) {
  for (const Track& track : tracks.tracks) m_parts.push_back(part(track, tracks.interval));
}

TrackParts::Part TrackParts::part(const Track& track, double interval) {
  const Dense at(track);
  const std::vector<double> lengths = step_lengths(at);
  const double per_hour = 3600.0 / interval;
  const auto span = static_cast<double>(track.span());
  Part part{};
  part.displacements = displacements(track, track.span());
  double path = 0.0; // NaN from a gap on
  for (std::size_t k = 1; k < at.size(); ++k) {
    path += lengths[k - 1];
    part.ratios.push_back(path > 0.0 ? at.distance(0, k) / path : nan);
  }
  part.speed = mean_of_defined(lengths) * per_hour;
  part.v_migr_abs = track.span() == 0 ? nan
                                      : std::hypot(track.x.back() - track.x.front(), track.y.back() - track.y.front())
                                            / span * per_hour;
  part.straightness = whole_ratio(track);
  part.windowed = windowed_ratio(at, lengths);
  part.anisotropy = anisotropy_of(at);
  std::tie(part.angle, part.cosine) = turning(at, lengths);
  return part;
}

std::vector<double> TrackParts::msd(std::span<const std::size_t> which) const {
  std::vector<double> sums, counts;
  for (const std::size_t k : which) {
    const auto& [squares, pairs] = m_parts[k].displacements;
    sums.resize(std::max(sums.size(), squares.size()), 0.0);
    counts.resize(sums.size(), 0.0);
    for (std::size_t lag = 0; lag < squares.size(); ++lag) {
      sums[lag] += squares[lag];
      counts[lag] += pairs[lag];
    }
  }
  for (std::size_t lag = 0; lag < sums.size(); ++lag) sums[lag] = counts[lag] > 0.0 ? sums[lag] / counts[lag] : nan;
  return sums;
}

ReadoutValues TrackParts::readouts(std::span<const std::size_t> which, double error) const {
  std::vector<double> square = msd(which);
  const bool is_buried = buried_of(square, error) > 0.0;
  for (double& one : square) one = is_buried ? nan : one - 4.0 * error * error;
  const std::size_t longest = square.size();
  const auto gathered = [&](double Part::*member) {
    std::vector<double> values;
    for (const std::size_t k : which) values.push_back(m_parts[k].*member);
    return statistics::finite(values);
  };
  std::vector<double> sums(longest, 0.0), counts(longest, 0.0);
  for (const std::size_t k : which)
    for (std::size_t i = 0; i < m_parts[k].ratios.size(); ++i)
      if (const double ratio = m_parts[k].ratios[i]; std::isfinite(ratio)) {
        sums[i] += ratio;
        counts[i] += 1.0;
      }
  for (std::size_t i = 0; i < longest; ++i) sums[i] = counts[i] > 0.0 ? sums[i] / counts[i] : nan;
  const std::vector<double> speeds = gathered(&Part::speed);
  const auto mean = [&](double Part::*member) { return mean_of_defined(gathered(member)); };
  const std::span<const double> lags(square.data(), std::min(longest, std::max<std::size_t>(3, longest / 3)));
  return {mean_of_defined(speeds),
          statistics::quantile(speeds, 0.5),
          statistics::quantile(speeds, 0.25),
          statistics::quantile(speeds, 0.75),
          mean(&Part::v_migr_abs),
          mean(&Part::straightness),
          mean(&Part::windowed),
          half_time(sums) * m_interval / 60.0,
          persistence(lags, m_interval) / 60.0,
          slope(square, 1, std::min<std::size_t>(4, longest)),
          slope(square, std::max<std::size_t>(1, longest / 8), longest / 2),
          statistics::quantile(gathered(&Part::anisotropy), 0.5),
          mean(&Part::angle),
          mean(&Part::cosine)};
}

std::vector<std::size_t> TrackParts::all() const {
  std::vector<std::size_t> indices(size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

std::string TrackParts::buried(double error) const {
  const double square = buried_of(msd(), error);
  if (!(square > 0.0)) return {};
  return fmt::format("MSD at one interval, {:.3g} um2, is below 4 error^2 = {:.3g} um2: the error is larger than the "
                     "cells move, so slopes and the persistence time are not defined",
                     square, 4.0 * error * error);
}

std::vector<ReadoutValues> TrackParts::drawn(double error, std::size_t resamples) const {
  std::vector<ReadoutValues> sets;
  if (size() < 2 || resamples < 2) return sets;
  for (std::size_t d = 0; d < resamples; ++d)
    sets.push_back(readouts(statistics::resampled(size(), draws_key, d), error));
  return sets;
}

ReadoutValues standard_errors(const ReadoutValues& value, std::span<const ReadoutValues> drawn) {
  ReadoutValues errors{};
  errors.fill(nan);
  for (std::size_t r = 0; r < track_readouts.size(); ++r) {
    std::vector<double> values;
    for (const ReadoutValues& one : drawn) values.push_back(one[r]);
    const statistics::Moments m = statistics::moments(statistics::finite(values));
    if (std::isfinite(value[r]) && m.n > 1 && static_cast<double>(m.n) >= 0.9 * static_cast<double>(drawn.size()))
      errors[r] = m.sd;
  }
  return errors;
}

} // namespace matrigrate::tracks
