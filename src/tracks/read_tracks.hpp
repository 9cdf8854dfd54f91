#pragma once

#include "tracks/options.hpp"
#include "tracks/spots.hpp"

#include <cstddef>
#include <filesystem>
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

/// The tracks of a file, and how the file was understood.
struct Tracks {
  std::vector<Track> tracks; ///< in the order in which the file has them
  double interval = 1.0;     ///< between positions [s]
  std::string encoding;
  std::string layout;
  char separator = '\0';
  bool decimal_comma = false;
  ColumnsUsed columns;
  Scales scales;
  std::vector<std::string> notes; ///< what was left out or decided, one sentence each

  double first() const; ///< start of the first track [s]
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

} // namespace matrigrate::tracks
