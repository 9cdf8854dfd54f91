#pragma once

#include "base/failure.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/readouts.hpp"

#include <algorithm>
#include <string>

/// Reading of files and texts in tests.
namespace matrigrate::tracks {

inline Tracks of_file(const std::string& name, const TrackOptions& options = {}) {
  return read_tracks(MATRIGRATE_TRACK_FILES "/" + name, options);
}

inline Tracks of_text(const std::string& text, const TrackOptions& options = {}) {
  return parse_tracks(text, "f", options);
}

/// What is wrong with a text; "none" if nothing is.
inline std::string faults(const std::string& text, const TrackOptions& options = {}) {
  try {
    of_text(text, options);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "none";
}

inline std::string faults_of_file(const std::string& name, const TrackOptions& options = {}) {
  try {
    of_file(name, options);
  } catch (const ConfigurationError& error) {
    const std::string text = error.what();
    return text.substr(text.find(name));
  }
  return "none";
}

inline double readout(const Tracks& tracks, std::string_view name) {
  const ReadoutValues values = TrackParts(tracks).readouts();
  const auto own = std::ranges::find(track_readouts, name, &ReadoutMeaning::name);
  return values.at(static_cast<std::size_t>(own - track_readouts.begin()));
}

inline double speed(const Tracks& tracks) { return readout(tracks, "speed_um_per_h"); }

inline bool notes(const Tracks& tracks, const std::string& note) {
  return std::ranges::find(tracks.notes, note) != tracks.notes.end();
}

/// Takes single and short tracks, too.
inline TrackOptions few(TrackOptions options = {}) {
  options.shortest = 2;
  options.fewest = 1;
  return options;
}

/// pixel and interval.
inline TrackOptions calibrated(double pixel, double interval) {
  TrackOptions options;
  options.pixel = pixel;
  options.interval = interval;
  return options;
}

} // namespace matrigrate::tracks
