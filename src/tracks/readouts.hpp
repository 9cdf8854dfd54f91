#pragma once

#include "tracks/read_tracks.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Read-outs of tracks at one interval. Only pairs of positions that are both there count: nothing is interpolated.
/// Test: tests/unit/tracks/readouts_test.cpp
namespace matrigrate::tracks {

struct ReadoutMeaning {
  std::string_view name;
  std::string_view unit; ///< empty of a ratio
  std::string_view meaning;
};

inline constexpr std::array<ReadoutMeaning, 14> track_readouts{{
    {"speed_um_per_h", "um/h", "speed from position to position, mean of each track, mean over tracks"},
    {"speed_median_um_per_h", "um/h", "the same, median over tracks"},
    {"speed_q25_um_per_h", "um/h", "the same, lower quartile over tracks"},
    {"speed_q75_um_per_h", "um/h", "the same, upper quartile over tracks"},
    {"v_migr_abs_um_per_h", "um/h", "speed from start to end, mean over tracks"},
    {"straightness", "", "distance from start to end over the length of the path, mean over tracks"},
    {"directionality_ratio", "", "the same over all windows of ten intervals, mean over tracks"},
    {"directionality_time_min", "min", "time from the start at which the mean of the ratio falls below one half"},
    {"persistence_min", "min", "persistence time of the persistent random walk fitted to the mean square displacement"},
    {"msd_slope_short", "", "log-log slope of the mean square displacement, lags of one to four intervals"},
    {"msd_slope_long", "", "the same, lags of an eighth to half of the longest track"},
    {"anisotropy", "", "mean square step along over across the main axis of each track, median over tracks"},
    {"turning_angle_deg", "deg", "angle between successive steps, without sign, mean of each track, mean over tracks"},
    {"turning_cosine", "", "cosine of this angle, mean of each track, mean over tracks"},
}};

/// In the order of track_readouts; NaN where tracks do not define it.
using ReadoutValues = std::array<double, track_readouts.size()>;

/// What each track contributes: read-outs of a resampled set need no more.
class TrackParts {
public:
  explicit TrackParts(const Tracks& tracks);

  std::size_t size() const { return m_parts.size(); }

  /// @param which  indices of tracks, repeated or not
  /// @param error  localisation error of a coordinate [um]: 4 error^2 is taken off the mean square displacement, and so
  ///               off its slopes and the persistence time; speeds, ratios and angles keep theirs
  ReadoutValues readouts(std::span<const std::size_t> which, double error) const;
  ReadoutValues readouts(double error = 0.0) const { return readouts(all(), error); }

  /// Read-outs of sets of tracks that are drawn from them with replacement, the same sets each time
  /// (statistics::resampled); none of a single track.
  std::vector<ReadoutValues> drawn(double error, std::size_t resamples) const;

  /// That the localisation error leaves nothing of the mean square displacement at the shortest lag, so that it defines
  /// no slope and no persistence time: a sentence; empty if it does.
  std::string buried(double error) const;

  /// Mean square displacement [um^2] at lags of 1, 2, ... intervals, over all pairs of positions; NaN without a pair.
  std::vector<double> msd(std::span<const std::size_t> which) const;
  std::vector<double> msd() const { return msd(all()); }

private:
  std::vector<std::size_t> all() const;
  struct Part {
    Displacements displacements;
    std::vector<double> ratios; ///< distance from the start over path, by time; NaN from a gap on
    double speed, v_migr_abs, straightness, windowed, anisotropy, angle, cosine;
  };
  static Part part(const Track& track, double interval);

  std::vector<Part> m_parts;
  double m_interval;
};

/// Standard errors of read-outs, by a bootstrap over tracks; NaN of what few of its sets define.
/// @param drawn  read-outs of the sets
ReadoutValues standard_errors(const ReadoutValues& value, std::span<const ReadoutValues> drawn);

/// Persistence time P [s] of Fuerth's formula, MSD(t) = 2 S^2 P (t - P (1 - exp(-t/P))), by least relative squares; NaN
/// where the lags cannot tell it: P below half an interval (a diffusive path) or above the largest lag (a straight
/// one), or a lag without a displacement.
double persistence(std::span<const double> square, double interval);

} // namespace matrigrate::tracks
