#include "tracks/spots.hpp"

#include "parameters/document.hpp"
#include "statistics/sample.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace matrigrate::tracks {

namespace {

constexpr double same_step = 0.05; ///< by which two statements of one interval may differ

using Time = std::pair<bool, double>; ///< whether by frames, and s per unit

bool about(double a, double b) { return std::abs(a - b) <= same_step * std::abs(b); }

/// Median steps along tracks; 0 without any.
struct Steps {
  double t, frame, t_per_frame;
  bool t_is_frame; ///< whether both are the same numbers
  bool counts;     ///< whether t can be a number of frames
};

Steps steps_of(const Spots& spots) {
  std::vector<std::size_t> order(spots.spots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto time = [&](const Spot& s) { return spots.has_frames() ? s.frame : s.t; };
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return std::pair(spots.spots[i].track, time(spots.spots[i])); });
  std::vector<double> t_steps, frame_steps, ratios;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Spot &a = spots.spots[order[i - 1]], &b = spots.spots[order[i]];
    if (a.track != b.track || !(time(b) > time(a))) continue;
    t_steps.push_back(b.t - a.t);
    frame_steps.push_back(b.frame - a.frame);
    if (spots.has_frames()) ratios.push_back((b.t - a.t) / (b.frame - a.frame));
  }
  const auto median = [](const std::vector<double>& x) { return x.empty() ? 0.0 : statistics::quantile(x, 0.5); };
  const double t = median(t_steps);
  return {.t = t,
          .frame = median(frame_steps),
          .t_per_frame = median(ratios),
          .t_is_frame = std::ranges::all_of(spots.spots, [](const Spot& s) { return s.t == s.frame; }),
          .counts = t == 1.0 && std::ranges::all_of(spots.spots, [](const Spot& s) { return s.t == std::round(s.t); })};
}

double length(const Spots& spots, const TrackOptions& options, Findings& findings) {
  const std::string unit = excerpt(spots.length_unit, 20);
  const std::optional<double> stated = length_unit(spots.length_unit);
  const ColumnNames& columns = spots.columns;
  const std::string pixel = options.say("pixel", "UM");
  if (!options.pixel && !stated)
    findings.fault(0, unit.empty() ? fmt::format("does not state the unit of {} and {}: give {}, um per unit (1 if um)",
                                                 columns.x, columns.y, pixel)
                                   : fmt::format("{} and {} are in {}: give {}, um per {}", columns.x, columns.y, unit,
                                                 pixel, unit));
  if (options.pixel && stated && std::abs(*stated - *options.pixel) > 1e-9 * *stated)
    findings.note("the file says that {} is in {}; it is taken as {:g} um per unit, as given", columns.x, unit,
                  *options.pixel);
  return options.pixel.value_or(stated.value_or(1.0));
}

/// Times are the numbers of frames, in their own column or in that of time.
Time of_frames(const Spots& spots, const Steps& steps, const TrackOptions& options, Findings& findings) {
  const bool own_column = spots.has_frames();
  const std::string& name = own_column ? spots.columns.frame : spots.columns.t;
  if (!options.interval)
    findings.fault(0, "its times are numbers of frames ({}): give {}, s from frame to frame", name,
                   options.say("interval", "S"));
  else if (const double step = own_column ? steps.frame : steps.t; step > 1.0)
    findings.note("{} rises by {:g} from position to position: positions are every {:g} s", name, step,
                  step * *options.interval);
  return {own_column, options.interval.value_or(1.0)};
}

/// By a column of time alone, without an interval from the caller.
Time of_t(const Spots& spots, const Steps& steps, std::optional<double> unit, bool calibrated,
          const TrackOptions& options, Findings& findings) {
  const std::string &t = spots.columns.t, &frame = spots.columns.frame;
  const std::string interval = options.say("interval", "S"), unit_of_time = options.say("time-unit", "s");
  if (!unit)
    findings.fault(0, "does not state the unit of {}: give {} (or min){}", t, unit_of_time,
                   spots.has_frames() ? fmt::format(", or {}, s from {} to {}", interval, frame, frame)
                   : steps.counts     ? fmt::format(", or {} if {} counts frames", interval, t)
                                      : "");
  else if (!calibrated && options.time_unit.empty())
    findings.fault(0,
                   "its movie was not calibrated: x is in no unit of length, and a frame lasts 1 s ({}): give {}, s "
                   "from frame to frame, or {} if it is 1 s",
                   t, interval, unit_of_time);
  return {false, unit.value_or(1.0)};
}

/// By a column of time, and the interval that the caller gives. It counts, whatever the file states; but a column
/// without a unit that rises otherwise may be what the caller means, so that is asked.
Time of_interval(const Spots& spots, const Steps& steps, std::optional<double> unit, bool calibrated,
                 const TrackOptions& options, Findings& findings) {
  const std::string &t = spots.columns.t, &frame = spots.columns.frame;
  const double interval = *options.interval, rise = spots.has_frames() ? steps.t_per_frame : steps.t;
  const char* const each = spots.has_frames() ? "frame" : "position";
  const bool some_unit = std::ranges::any_of(
      time_units(), [&](const std::string& name) { return about(rise * time_unit(name).value_or(0.0), interval); });
  const bool agrees = unit ? about(rise * *unit, interval) : spots.has_frames() && some_unit;
  const bool counts = spots.has_frames() ? steps.t_is_frame : steps.counts;
  if (!unit && !agrees && !counts && rise > 0.0)
    findings.fault(0, "{} rises by {:.6g} from {} to {}, and its unit is not stated: give {} (or min) and no {}{}", t,
                   rise, each, each, options.say("time-unit", "s"), options.say("interval"),
                   spots.has_frames() ? fmt::format(", or {} if {} is wrong",
                                                    options.say("columns", fmt::format("frame={}", frame)), t)
                                      : "");
  if (!spots.has_frames() && unit && agrees) return {false, *unit};
  if (!calibrated)
    findings.note("the movie was not calibrated ({} counts frames): times are {} x {:g} s", t, frame, interval);
  else if (unit && !agrees && rise > 0.0)
    findings.note("{} says {:.6g} s from {} to {}; it is taken as {:g} s, as given", t, rise * *unit, each, each,
                  interval);
  else if (spots.has_frames())
    findings.note("times are {} x {:g} s; {} is not used", frame, interval, t);
  else
    findings.note("{} counts frames: times are {} x {:g} s", t, t, interval);
  if (spots.has_frames()) return of_frames(spots, steps, options, findings);
  return {false, unit && rise > 0.0 ? interval / rise : interval};
}

Time time(const Spots& spots, const TrackOptions& options, Findings& findings) {
  const Steps steps = steps_of(spots);
  const std::optional<double> stated = time_unit(spots.time_unit);
  const bool frames = !spots.has_t() || counts_frames(spots.time_unit), asked = !options.time_unit.empty();
  const std::optional<double> unit = asked ? time_unit(options.time_unit) : stated;
  if (asked && !spots.has_t())
    findings.fault(0, "{}: there is no column of time; give {}, s from frame to frame", options.say("time-unit"),
                   options.say("interval", "S"));
  else if (asked && (frames || (stated && *stated != *unit)))
    findings.note("the file says that {} is in {}; it is taken as in {}, as given", spots.columns.t,
                  excerpt(spots.time_unit, 20), options.time_unit);
  if (!spots.has_t() || (frames && !asked)) return of_frames(spots, steps, options, findings);
  // One second from frame to frame, and no unit of length, is what TrackMate writes if it knows neither.
  const bool calibrated =
      !spots.has_frames() || !steps.t_is_frame || length_unit(spots.length_unit) || (unit && *unit != 1.0);
  return options.interval ? of_interval(spots, steps, unit, calibrated, options, findings)
                          : of_t(spots, steps, unit, calibrated, options, findings);
}

/// Numbers so large that sums of their squares would overflow are no positions.
void check_bounds(const Spots& spots, Findings& findings) {
  constexpr double largest_length = 1e9; // [um]
  constexpr double largest_time = 1e10;  // [s]
  for (const Spot& s : spots.spots) {
    for (const double value : {s.x, s.y})
      if (!(std::abs(value) <= largest_length))
        findings.fault(s.line, "a position of {:g} um is out of range; allowed is {:g} um on either side", value,
                       largest_length);
    if (!(std::abs(s.t) <= largest_time))
      findings.fault(s.line, "a time of {:g} s is out of range; allowed is {:g} s", s.t, largest_time);
  }
}

} // namespace

void calibrate(Spots& spots, const TrackOptions& options, Findings& findings) {
  const double um = length(spots, options, findings);
  const auto [by_frame, s_per_unit] = time(spots, options, findings);
  for (Spot& s : spots.spots) {
    s.x *= um;
    s.y *= um;
    s.t = (by_frame ? s.frame : s.t) * s_per_unit;
  }
  spots.t_digit *= by_frame ? 0.0 : s_per_unit;
  check_bounds(spots, findings);
  spots.scales = {.um_per_unit = um, .s_per_unit = s_per_unit, .by_frame = by_frame};
}

} // namespace matrigrate::tracks
