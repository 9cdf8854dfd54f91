#include "tracks/read_tracks.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/document.hpp"
#include "statistics/sample.hpp"
#include "tracks/layouts.hpp"
#include "tracks/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace matrigrate::tracks {

namespace {

constexpr std::size_t longest = 100'000;           ///< intervals of a track
constexpr std::size_t most_intervals = 20'000'000; ///< of all tracks

constexpr const char* no_name = "NAME";

/// The last digit of times, over the interval: beyond this the number of intervals cannot be told.
constexpr double most_rounding = 0.4;

/// Steps of a track that are not all across gaps by chance.
constexpr std::size_t enough_steps = 5;

/// The positions of a track in the order of time.
struct Path {
  std::string name;
  std::vector<Spot> spots;
};

/// Makes tracks at one interval of positions at times: a step that is no whole multiple of it within options.jitter is
/// a fault, and so is a track that splits, unless options.splits says what is done with it.
class Grid {
public:
  /// @param spots  calibrated: um and s
  Grid(const Spots& spots, const TrackOptions& options, Findings& findings)
      : m_options(options), m_findings(findings), m_exact(spots.scales.by_frame),
        m_digit(m_exact ? 0.0 : spots.t_digit) {
    if (!spots.apart.empty()) m_apart = spots.apart;
    m_paths.resize(spots.names.size());
    for (std::size_t k = 0; k < m_paths.size(); ++k) m_paths[k].name = spots.names[k];
    for (const Spot& s : spots.spots) m_paths[s.track].spots.push_back(s);
    for (Path& path : m_paths) std::ranges::stable_sort(path.spots, {}, &Spot::t);
  }

  void fill(Tracks& tracks) {
    handle_splits();
    leave_short_out();
    find_interval();
    if (m_paths.size() < m_options.fewest)
      m_findings.fault(0, "has {} of at least {}; {} are needed to tell how cells differ ({}, {})",
                       counted(m_paths.size(), "track"), counted(m_options.shortest, "position"), m_options.fewest,
                       m_options.say("shortest"), m_options.say("fewest"));
    if (!m_findings.good()) return;
    for (const Path& path : m_paths) place(path, tracks);
    if (!m_findings.good()) return;
    tracks.interval = refined(tracks);
    set_starts(tracks);
  }

private:
  /// What is done with tracks that have two positions at one time.
  void handle_splits() {
    std::size_t split = 0;
    const std::size_t all = m_paths.size();
    std::vector<std::pair<std::size_t, std::string>> faults;
    for (Path& path : m_paths) {
      const auto twin = std::ranges::adjacent_find(path.spots, {}, &Spot::t);
      if (twin == path.spots.end()) continue;
      ++split;
      if (m_options.splits == Splits::cut)
        path.spots.erase(twin, path.spots.end());
      else if (m_options.splits == Splits::drop)
        path.spots.clear();
      else
        faults.emplace_back((twin + 1)->line,
                            fmt::format("track {} has two positions at {:g} s", excerpt(path.name, 40), twin->t));
    }
    if (split == 0) return;
    if (m_options.splits != Splits::refuse)
      return m_findings.note("{} of {} {}: {}", split, counted(all, "track"),
                             split == 1 ? "splits or merges" : "split or merge",
                             m_options.splits == Splits::cut ? "cut before it" : "left out");
    const std::string way = fmt::format("{} ends it before, {} leaves it out", m_options.say("splits", "cut"),
                                        m_options.say("splits", "drop"));
    const std::string ids = fmt::format("do ids repeat in several movies? {} tells them apart",
                                        m_options.say("columns", fmt::format("group={}", m_apart)));
    for (auto& [line, what] : faults)
      m_findings.fault_of_kind(
          "twice", line,
          fmt::format("{}: {}", what,
                      m_apart != no_name || (2 * split > all && all > 1) ? ids : "it splits or merges; " + way));
  }

  void leave_short_out() {
    std::size_t shorter = 0;
    const std::size_t least = std::max<std::size_t>(2, m_options.shortest);
    std::erase_if(m_paths, [&](const Path& path) {
      if (path.spots.size() >= least) return false;
      shorter += path.spots.empty() ? 0 : 1;
      return true;
    });
    if (shorter > 0)
      m_findings.note("{} of fewer than {} {} left out", counted(shorter, "track"), counted(least, "position"),
                      shorter == 1 ? "is" : "are");
  }

  /// The most frequent step if a third of all are such, else the median: time stamps scatter.
  void find_interval() {
    std::map<double, std::size_t> counts;
    std::vector<double> steps;
    for (const Path& path : m_paths)
      for (std::size_t i = 1; i < path.spots.size(); ++i) {
        const double step = path.spots[i].t - path.spots[i - 1].t;
        if (!(step > 0.0)) continue;
        steps.push_back(step);
        ++counts[std::strtod(fmt::format("{:.6g}", step).c_str(), nullptr)];
      }
    if (steps.empty()) return;
    const auto most = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    m_most = 2 * most->second > steps.size();
    m_frequent = m_most || (most->second > 1 && 3 * most->second >= steps.size());
    std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
    m_interval = m_frequent ? most->first : steps[steps.size() / 2];
    const double usual = m_interval;
    double duration = 0.0, intervals = 0.0;
    for (const double step : steps) {
      duration += step;
      intervals += std::max(1.0, std::round(step / usual));
    }
    const double mean = duration / intervals;
    m_rounded = m_digit > std::max(m_options.jitter, 1e-6) * mean && m_digit <= most_rounding * mean
                && std::ranges::any_of(steps, [&](double step) {
                     return std::abs(step / usual - std::round(step / usual)) > std::max(m_options.jitter, 1e-6);
                   });
    if (m_rounded) m_interval = roundest(mean);
  }

  /// The number of the fewest digits that times rounded so cannot tell from an interval.
  double roundest(double interval) const {
    double most = 1.0;
    for (const Path& path : m_paths) most = std::max(most, (path.spots.back().t - path.spots.front().t) / interval);
    for (int digits = 1; digits < 6; ++digits)
      if (const double one = std::strtod(fmt::format("{:.{}e}", interval, digits - 1).c_str(), nullptr);
          std::abs(one - interval) * most <= m_digit)
        return one;
    return interval;
  }

  /// By how much a step may differ from whole intervals, as a share of one.
  double tolerance() const { return std::max({m_options.jitter, 1e-6, m_rounded ? 1.01 * m_digit / m_interval : 0.0}); }

  /// A track on the grid from its first position on; the first step that does not fit is its fault.
  void place(const Path& path, Tracks& tracks) {
    Track track{
        .name = path.name, .start = path.spots.front().t, .k = {0}, .x = {path.spots[0].x}, .y = {path.spots[0].y}};
    std::size_t smallest = longest;
    double off = 0.0;
    for (std::size_t i = 1; i < path.spots.size(); ++i) {
      const Spot& spot = path.spots[i];
      const double step = (spot.t - path.spots[i - 1].t) / m_interval;
      const double whole = std::round(step);
      if (!(std::abs(step - whole) <= tolerance()) || whole < 1.0) return tell_step(path, i);
      if (whole + static_cast<double>(track.span()) > static_cast<double>(longest))
        return m_findings.fault(spot.line, "track {} spans more than {} intervals of {:g} s", excerpt(path.name, 40),
                                longest, m_interval);
      const auto by = static_cast<std::size_t>(whole);
      m_scatter.push_back(step * m_interval - whole * m_interval);
      off += m_scatter.back();
      if (m_rounded && std::abs(off) > 1.01 * m_digit) return tell_step(path, i); // rounding does not add up
      smallest = std::min(smallest, by);
      track.k.push_back(track.span() + by);
      track.x.push_back(spot.x);
      track.y.push_back(spot.y);
    }
    if (smallest > 1 && track.k.size() > enough_steps)
      return m_findings.fault(path.spots[1].line,
                              "track {} has steps of {:g} s and more, {} {:g} s: one interval is needed",
                              excerpt(path.name, 40), static_cast<double>(smallest) * m_interval, rule(), m_interval);
    m_intervals += track.span();
    if (m_intervals > most_intervals) {
      if (m_intervals - track.span() <= most_intervals)
        m_findings.fault(0, "its tracks span more than {} intervals", most_intervals);
      return;
    }
    tracks.tracks.push_back(std::move(track));
  }

  std::string rule() const { return m_most ? "most have" : m_frequent ? "the most frequent is" : "the median is"; }

  void tell_step(const Path& path, std::size_t i) {
    m_findings.fault(path.spots[i].line,
                     "track {} has a step of {:.6g} s, {} {:.6g} s: one interval is needed, within {:g} % ({})",
                     excerpt(path.name, 40), path.spots[i].t - path.spots[i - 1].t, rule(), m_interval,
                     100.0 * m_options.jitter, m_options.say("jitter", fmt::format("{:g}", m_options.jitter)));
  }

  /// Of time stamps that scatter, the interval is their mean step; a note tells the scatter.
  double refined(const Tracks& tracks) {
    double square = 0.0, largest = 0.0;
    for (const double s : m_scatter) {
      square += s * s;
      largest = std::max(largest, std::abs(s));
    }
    if (m_exact || !(largest > 1e-4 * m_interval)) return m_interval;
    if (m_rounded) {
      m_findings.note("times are rounded to {:g} s: positions are taken as every {:g} s", m_digit, m_interval);
      return m_interval;
    }
    double duration = 0.0, intervals = 0.0;
    std::size_t path = 0;
    for (const Track& track : tracks.tracks) {
      const std::vector<Spot>& spots = m_paths[path++].spots;
      duration += spots.back().t - spots.front().t;
      intervals += static_cast<double>(track.span());
    }
    const double interval = std::strtod(fmt::format("{:.6g}", duration / intervals).c_str(), nullptr);
    m_findings.note("time stamps scatter: steps differ from {:g} s by {:.2g} % (root mean square), at most {:.2g} %",
                    interval, 100.0 * std::sqrt(square / static_cast<double>(m_scatter.size())) / m_interval,
                    100.0 * largest / m_interval);
    return interval;
  }

  /// Tracks whose starts are whole intervals apart stand on common times; the others keep theirs.
  void set_starts(Tracks& tracks) {
    double first = tracks.tracks.front().start;
    for (const Track& track : tracks.tracks) first = std::min(first, track.start);
    std::size_t off = 0;
    for (Track& track : tracks.tracks) {
      const double at = (track.start - first) / tracks.interval;
      // The interval may be wrong in its last digits, so that times far from the first are less certain.
      if (std::abs(at - std::round(at)) <= tolerance()) {
        track.start = m_exact ? track.start : first + std::round(at) * tracks.interval;
      } else {
        ++off;
      }
    }
    if (off > 0)
      m_findings.note("{} {} between the times of the others, and {} own times", counted(off, "track"),
                      off == 1 ? "begins" : "begin", off == 1 ? "keeps its" : "keep their");
  }

  const TrackOptions& m_options;
  Findings& m_findings;
  bool m_exact;                  ///< whether times are multiples of the interval from frame to frame, not time stamps
  double m_digit;                ///< that times are written to [s]
  bool m_rounded = false;        ///< whether it explains how steps differ
  std::string m_apart = no_name; ///< the column that tells movies apart
  std::vector<Path> m_paths;
  double m_interval = 1.0;
  bool m_frequent = true;        ///< whether m_interval is the most frequent step
  bool m_most = true;            ///< whether m_interval is the step of more than half of all
  std::vector<double> m_scatter; ///< of steps [s]
  std::size_t m_intervals = 0;
};

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
  if (speed > fast) findings.note("{:.0f} um/h is faster than cells crawl: are the units right?", speed);
  if (speed > 0.0 && speed < slow) findings.note("{:.2g} um/h is slower than cells crawl: are the units right?", speed);
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
  calibrate(spots, options, findings);
  static_cast<Understood&>(tracks) = spots;
  tracks.encoding = text.encoding;
  if (findings.good()) Grid(spots, options, findings).fill(tracks);
  if (!findings.good()) return;
  if (tracks.missing() > 0)
    findings.note("{} {} missing within tracks; gaps are not filled", counted(tracks.missing(), "position"),
                  tracks.missing() == 1 ? "is" : "are");
  look_at_motion(tracks, options, findings);
}

[[noreturn]] void refuse(const std::string& file, std::string message) {
  throw ConfigurationError({{file, 0, 0, {}, std::move(message)}});
}

} // namespace

double Tracks::first() const {
  return tracks.empty() ? 0.0 : std::ranges::min_element(tracks, {}, &Track::start)->start;
}

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
  if (last > most_times) refuse(file, fmt::format("its tracks are {} intervals apart: drift cannot be found", last));
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
    refuse(file, fmt::format("at no time {} of {} tracks go on together, so drift cannot be separated from migration",
                             least_for_drift, tracks.tracks.size()));
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
