#include "target.hpp"

#include "base/failure.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/readouts.hpp"

#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

using namespace matrigrate::tracks;

/// What is read must be finite, on one interval, and the same when it is written in the plain form and read again.
void require_whole(const Tracks& tracks) {
  std::size_t positions = 0;
  for (const Track& track : tracks.tracks) {
    if (track.k.empty() || track.k.front() != 0) std::abort();
    for (std::size_t i = 0; i < track.k.size(); ++i) {
      if (!(std::isfinite(track.x[i]) && std::isfinite(track.y[i]))) std::abort();
      if (i > 0 && track.k[i] <= track.k[i - 1]) std::abort();
    }
    positions += track.k.size();
  }
  if (positions != tracks.positions() || !(tracks.interval > 0.0)) std::abort();
  for (const double value : TrackParts(tracks).readouts())
    if (std::isinf(value)) std::abort();
}

void require_kept(const Tracks& tracks, TrackOptions options) {
  options.pixel.reset();
  options.interval.reset();
  options.time_unit.clear();
  options.columns = {};
  options.may_stand = true; // rounding may have been all of a motion
  if (parse_tracks(plain_csv(tracks), "plain", options).positions() != tracks.positions()) std::abort();
}

} // namespace

/// A file of tracks from anywhere, with options that its first byte chooses: it is refused with all its faults, or
/// read.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const unsigned how = data[0];
  TrackOptions options;
  options.shortest = 2;
  options.fewest = 1;
  if ((how & 1U) != 0) options.pixel = 0.5;
  if ((how & 2U) != 0) options.interval = 120.0;
  if ((how & 4U) != 0) options.time_unit = "min";
  options.splits = static_cast<Splits>((how >> 4U) % 3U);
  if ((how & 64U) != 0) add_columns("track=1,t=2,x=3,y=4", options.columns);
  try {
    const Tracks tracks = parse_tracks(bytes, "fuzz.csv", options);
    require_whole(tracks);
    require_kept(tracks, options);
  } catch (const matrigrate::ConfigurationError& error) {
    if (error.faults().empty()) std::abort();
  }
  return 0;
}
