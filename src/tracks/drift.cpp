#include "tracks/read_tracks.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::tracks {

namespace {

constexpr std::size_t most_times = 10'000'000; ///< between the first and the last position

/// Sum of the steps that end at a time.
struct Sum {
  double x = 0.0, y = 0.0;
  std::size_t n = 0;

  bool counts() const { return n >= least_for_drift; }
};

std::vector<Sum> sums_of(const Tracks& tracks, double first, const std::string& file) {
  std::size_t last = 0;
  for (const Track& track : tracks.tracks) last = std::max(last, tracks.offset(track, first) + track.span());
  if (last > most_times)
    throw ConfigurationError(
        {{file, 0, 0, {}, fmt::format("its tracks are {} intervals apart: drift cannot be found", last)}});
  std::vector<Sum> sums(last + 1);
  for (const Track& track : tracks.tracks) {
    const std::size_t offset = tracks.offset(track, first);
    for (std::size_t i = 1; i < track.k.size(); ++i)
      if (track.k[i] == track.k[i - 1] + 1) {
        Sum& sum = sums[offset + track.k[i]];
        sum.x += track.x[i] - track.x[i - 1];
        sum.y += track.y[i] - track.y[i - 1];
        ++sum.n;
      }
  }
  return sums;
}

/// "0 to 600 s, 900 to 1200 s": the intervals that count, or those that do not.
std::string stretches(const std::vector<Sum>& sums, bool counting, double first, double interval) {
  constexpr std::size_t most = 3;
  std::vector<std::string> all;
  for (std::size_t k = 1; k < sums.size();) {
    std::size_t end = k;
    while (end < sums.size() && sums[end].counts() == sums[k].counts()) ++end;
    if (sums[k].counts() == counting)
      all.push_back(fmt::format("{:g} to {:g} s", first + static_cast<double>(k - 1) * interval,
                                first + static_cast<double>(end - 1) * interval));
    k = end;
  }
  const bool more = all.size() > most;
  if (more) all.resize(most);
  return fmt::format("{}{}", fmt::join(all, ", "), more ? ", ..." : "");
}

} // namespace

Drift drift_of(const Tracks& tracks, const std::string& file) {
  const double first = tracks.first();
  const std::vector<Sum> sums = sums_of(tracks, first, file);
  Drift drift{.x = std::vector<double>(sums.size(), 0.0), .y = std::vector<double>(sums.size(), 0.0), .said = {}};
  std::size_t least = tracks.tracks.size(), most = 0;
  for (std::size_t k = 1; k < sums.size(); ++k) {
    const Sum& sum = sums[k];
    drift.x[k] = drift.x[k - 1] + (sum.counts() ? sum.x / static_cast<double>(sum.n) : 0.0);
    drift.y[k] = drift.y[k - 1] + (sum.counts() ? sum.y / static_cast<double>(sum.n) : 0.0);
    if (!sum.counts()) continue;
    least = std::min(least, sum.n);
    most = std::max(most, sum.n);
  }
  if (most == 0) return drift;
  const std::string none = stretches(sums, false, first, tracks.interval);
  drift.said =
      fmt::format("a drift of {:.3g} um is taken away, the mean motion of {} tracks from {}{}",
                  std::hypot(drift.x.back(), drift.y.back()),
                  least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most),
                  stretches(sums, true, first, tracks.interval),
                  none.empty() ? "" : fmt::format("; none from {}, where fewer than {} go on", none, least_for_drift));
  return drift;
}

void take_drift_away(Tracks& tracks, const std::string& file) {
  const Drift drift = drift_of(tracks, file);
  if (drift.said.empty())
    throw ConfigurationError(
        {{file,
          0,
          0,
          {},
          fmt::format("at no time {} of {} tracks go on together, so drift cannot be separated from migration",
                      least_for_drift, tracks.tracks.size())}});
  const double first = tracks.first();
  for (Track& track : tracks.tracks) {
    const std::size_t offset = tracks.offset(track, first);
    for (std::size_t i = 0; i < track.k.size(); ++i) {
      track.x[i] -= drift.x[offset + track.k[i]];
      track.y[i] -= drift.y[offset + track.k[i]];
    }
  }
  tracks.notes.push_back(drift.said);
}

} // namespace matrigrate::tracks
