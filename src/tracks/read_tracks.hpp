#pragma once

#include "tracks/options.hpp"
#include "tracks/spots.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Measured tracks from the files of tracking programs. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// Positions of one cell at multiples of an interval, some of them missing.
struct Track {
  std::string name;
  double start = 0.0;         ///< time of the first position [s]
  std::vector<std::size_t> k; ///< intervals since then, rising, from 0
  std::vector<double> x;      ///< [um]
  std::vector<double> y;

  /// Intervals from the first position to the last.
  std::size_t span() const { return k.empty() ? 0 : k.back(); }
};

/// The tracks of a file.
struct Tracks : Understood {
  std::vector<Track> tracks;      ///< in the order in which the file has them
  double interval = 1.0;          ///< between positions [s]
  std::vector<std::string> notes; ///< what was left out or decided, one sentence each

  double first() const; ///< start of the first track [s]; 0 if there is none
  /// Intervals from `first` [s] to the start of a track.
  std::size_t offset(const Track& track, double first) const;
  std::size_t positions() const;
  std::size_t missing() const; ///< positions within tracks
};

/// @throws InputOutputError if the file cannot be read
/// @throws ConfigurationError with all that is wrong with the file, or with the options
Tracks read_tracks(const std::filesystem::path& file, const TrackOptions& options);

/// @param bytes  of the file   @param name  of it, for messages
Tracks parse_tracks(std::string_view bytes, const std::string& name, const TrackOptions& options);

/// The positions at a longer interval, from the start of each track on.
/// @throws ConfigurationError if it is no whole multiple of theirs
Tracks at_interval(const Tracks& tracks, double interval, const std::string& file);

/// The plain form: track,t_s,x_um,y_um, a row per position. It is read back as the same tracks.
std::string plain_csv(const Tracks& tracks);

// The motion that all tracks have in common. Test: tests/unit/tracks/readouts_test.cpp

inline constexpr std::size_t least_for_drift = 5; ///< tracks that go on over an interval

/// Sum of the mean steps of the tracks, from the first start on: the drift of the stage, if cells have no common
/// direction of their own. With n tracks its error is their mean step over the root of n. An interval over which fewer
/// than five tracks go on has no drift: there the own way of a cell would be taken for it.
struct Drift {
  std::vector<double> x, y; ///< [um] at 0, 1, 2 ... intervals
  std::string said;         ///< from when to when, and how many tracks stand behind it; empty if no interval has any
};

/// @param file  of the tracks, for the message
/// @throws ConfigurationError if tracks are too far apart in time
Drift drift_of(const Tracks& tracks, const std::string& file = {});

/// Less their drift, with a note of how much it was. It takes a common direction of the cells away, too.
/// @throws ConfigurationError also if at no time enough tracks go on
void take_drift_away(Tracks& tracks, const std::string& file = {});

// Square displacements of measured and of simulated cells. Test: tests/unit/tracks/readouts_test.cpp

/// Square displacements over all pairs of positions, at lags of 1, 2, ... intervals.
struct Displacements {
  std::vector<double> squares; ///< sum [um^2]
  std::vector<double> pairs;   ///< how many
};

/// @param longest  lag
Displacements displacements(const Track& track, std::size_t longest);

/// Slope of log y over log x by least squares, of the points whose y is above 0. NaN of fewer than `least` of them.
double log_slope(std::span<const double> x, std::span<const double> y, std::size_t least);

} // namespace matrigrate::tracks
