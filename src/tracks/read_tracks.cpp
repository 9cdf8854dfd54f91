#include "tracks/read_tracks.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "statistics/sample.hpp"
#include "tracks/grid.hpp"
#include "tracks/layouts.hpp"
#include "tracks/leaps.hpp"
#include "tracks/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace matrigrate::tracks {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 28;
constexpr double fast = 1800.0; ///< [um/h]: 30 um/min, of the fastest crawling cells (keratocytes, neutrophils)
constexpr double slow = 0.02;   ///< [um/h]

/// Speed from position to position, median over all steps [um/h].
double median_speed(const Tracks& tracks) {
  std::vector<double> speeds;
  for (const Track& track : tracks.tracks)
    for (std::size_t i = 1; i < track.k.size(); ++i)
      speeds.push_back(std::hypot(track.x[i] - track.x[i - 1], track.y[i] - track.y[i - 1]) * 3600.0
                       / (static_cast<double>(track.k[i] - track.k[i - 1]) * tracks.interval));
  return speeds.empty() ? 0.0 : statistics::quantile(speeds, 0.5);
}

void look_at_motion(const Tracks& tracks, const TrackOptions& options, Findings& findings) {
  const auto stands = [](const std::vector<double>& x) {
    return std::ranges::all_of(x, [&](double one) { return one == x[0]; });
  };
  const auto is_still = [&](const Track& track) { return stands(track.x) && stands(track.y); };
  if (!options.may_stand && std::ranges::all_of(tracks.tracks, is_still))
    return findings.fault(0, "no track moves: all positions of a track are the same");
  const double speed = median_speed(tracks);
  if (speed > fast) findings.note(fmt::format("{:.0f} um/h is faster than cells crawl: are the units right?", speed));
  if (speed > 0.0 && speed < slow)
    findings.note(fmt::format("{:.2g} um/h is slower than cells crawl: are the units right?", speed));
  look_for_leaps(tracks, options, findings);
}

/// What comes of a text: its spots, calibrated and on one interval.
void fill(const Text& text, const TrackOptions& options, Tracks& tracks, Findings& findings) {
  const std::string_view start = trimmed(std::string_view(text.utf8).substr(0, 1000));
  Spots spots = start.starts_with('<')          ? xml_spots(text.utf8, findings)
                : start.starts_with("MTrackJ ") ? mtrackj_spots(text.utf8, findings)
                                                : table_spots(text.utf8, options, findings);
  if (findings.good() && spots.spots.empty()) findings.fault(0, "has no position in a track");
  if (!findings.good()) return;
  tracks.encoding = text.encoding;
  tracks.layout = spots.layout;
  tracks.separator = spots.separator;
  tracks.decimal_comma = spots.decimal_comma;
  tracks.columns = spots.columns;
  tracks.scales = calibrate(spots, options, findings);
  if (findings.good()) put_on_grid(spots, tracks.scales.by_frame, options, tracks, findings);
  if (!findings.good()) return;
  if (tracks.missing() > 0)
    findings.note(fmt::format("{} missing within tracks; gaps are not filled",
                              counted(tracks.missing(), "position") + (tracks.missing() == 1 ? " is" : " are")));
  look_at_motion(tracks, options, findings);
}

[[noreturn]] void refuse(const std::string& file, std::string message) {
  throw ConfigurationError({{file, 0, 0, {}, std::move(message)}});
}

} // namespace

double Tracks::first() const { return std::ranges::min_element(tracks, {}, &Track::start)->start; }

std::size_t Tracks::offset(const Track& track, double first) const {
  return static_cast<std::size_t>(std::llround((track.start - first) / interval));
}

std::size_t Tracks::positions() const {
  std::size_t sum = 0;
  for (const Track& track : tracks) sum += track.k.size();
  return sum;
}

std::size_t Tracks::missing() const {
  std::size_t sum = 0;
  for (const Track& track : tracks) sum += track.span() + 1 - track.k.size();
  return sum;
}

Tracks parse_tracks(std::string_view bytes, const std::string& name, const TrackOptions& options) {
  Tracks tracks;
  Findings findings(name);
  const Text text = decoded(bytes, findings);
  if (findings.good()) fill(text, options, tracks, findings);
  findings.raise();
  tracks.notes = std::move(findings.notes());
  return tracks;
}

Tracks read_tracks(const std::filesystem::path& file, const TrackOptions& options) {
  return parse_tracks(read_file(file, largest_file), file.string(), options);
}

Tracks at_interval(const Tracks& tracks, double interval, const std::string& file) {
  const double share = interval / tracks.interval;
  const double many = std::round(share);
  if (!(many >= 1.0 && many <= 1e6) || std::abs(share - many) > 0.01)
    refuse(file, fmt::format("{:g} s is no whole multiple of its interval, {:g} s", interval, tracks.interval));
  const auto every = static_cast<std::size_t>(many);
  Tracks sparse = tracks;
  sparse.interval = tracks.interval * many;
  for (Track& track : sparse.tracks) {
    Track kept{.name = track.name, .start = track.start, .k = {}, .x = {}, .y = {}};
    for (std::size_t i = 0; i < track.k.size(); ++i)
      if (track.k[i] % every == 0) {
        kept.k.push_back(track.k[i] / every);
        kept.x.push_back(track.x[i]);
        kept.y.push_back(track.y[i]);
      }
    track = std::move(kept);
  }
  return sparse;
}

std::string plain_csv(const Tracks& tracks) {
  std::string csv = "track,t_s,x_um,y_um\n";
  for (const Track& track : tracks.tracks)
    for (std::size_t i = 0; i < track.k.size(); ++i)
      csv += fmt::format("{},{},{},{}\n", csv_text(track.name),
                         track.start + static_cast<double>(track.k[i]) * tracks.interval, track.x[i], track.y[i]);
  return csv;
}

} // namespace matrigrate::tracks
