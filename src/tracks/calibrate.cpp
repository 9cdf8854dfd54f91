#include "tracks/calibrate.hpp"

#include "parameters/scan.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace matrigrate::tracks {

namespace {

constexpr double largest_length = 1e9; ///< [um]
constexpr double largest_time = 1e10;  ///< [s]
constexpr double same_step = 0.05;     ///< by which two statements of one interval may differ

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

bool about(double a, double b) { return std::abs(a - b) <= same_step * std::abs(b); }

/// Decides on the time of spots, and on their length.
class Calibration {
public:
  Calibration(const Spots& spots, const TrackOptions& options, Findings& findings)
      : m_spots(spots), m_options(options), m_findings(findings) {
    measure_steps();
  }

  Scales scales() {
    Scales scales;
    scales.um_per_unit = length();
    const auto [by_frame, s] = time();
    scales.by_frame = by_frame;
    scales.s_per_unit = s;
    return scales;
  }

private:
  using Time = std::pair<bool, double>; ///< whether by frames, and s per unit

  /// Median steps of t and of the frames along tracks, and of t from frame to frame.
  void measure_steps() {
    std::vector<std::size_t> order(m_spots.spots.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const bool frames = m_spots.has_frames();
    const auto time = [&](const Spot& s) { return frames ? s.frame : s.t; };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      const Spot &left = m_spots.spots[a], &right = m_spots.spots[b];
      return left.track != right.track ? left.track < right.track : time(left) < time(right);
    });
    std::vector<double> t_steps, frame_steps, ratios;
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Spot &a = m_spots.spots[order[i - 1]], &b = m_spots.spots[order[i]];
      if (a.track != b.track || !(time(b) > time(a))) continue;
      t_steps.push_back(b.t - a.t);
      frame_steps.push_back(b.frame - a.frame);
      if (frames) ratios.push_back((b.t - a.t) / (b.frame - a.frame));
    }
    m_t_step = median_of(t_steps);
    m_frame_step = median_of(frame_steps);
    m_t_per_frame = median_of(ratios);
    m_t_is_frame = std::ranges::all_of(m_spots.spots, [](const Spot& s) { return s.t == s.frame; });
    m_t_is_whole = std::ranges::all_of(m_spots.spots, [](const Spot& s) { return s.t == std::round(s.t); });
  }

  double length() {
    const std::string& unit = m_spots.length_unit;
    const std::optional<double> stated = length_unit(unit);
    if (!m_options.pixel) {
      if (!stated)
        m_findings.fault(0, unit.empty()
                                ? fmt::format("does not state the unit of {} and {}: give {}, um per unit (1 if um)",
                                              m_spots.columns.x, m_spots.columns.y, m_options.say("pixel", "UM"))
                                : fmt::format("{} and {} are in {}: give {}, um per {}", m_spots.columns.x,
                                              m_spots.columns.y, excerpt(unit, 20), m_options.say("pixel", "UM"),
                                              excerpt(unit, 20)));
      return stated.value_or(1.0);
    }
    if (!stated || std::abs(*stated - *m_options.pixel) <= 1e-9 * *stated) return *m_options.pixel;
    if (m_options.recalibrate)
      m_findings.note(fmt::format("the file says that {} is in {}; it is taken as {:g} um per unit", m_spots.columns.x,
                                  excerpt(unit, 20), *m_options.pixel));
    else
      contradict(fmt::format("{} is in {}", m_spots.columns.x, excerpt(unit, 20)),
                 m_options.say("pixel", fmt::format("{:g}", *m_options.pixel)));
    return *m_options.pixel;
  }

  void contradict(const std::string& what, const std::string& option) {
    m_findings.fault(0, fmt::format("{}; {} contradicts it: leave it out, or add {} if the file is wrong", what, option,
                                    m_options.say("recalibrate", m_options.spelling == Spelling::keys ? "true" : "")));
  }

  Time time() {
    const std::optional<double> stated = time_unit(m_spots.time_unit);
    const bool frames_as_t = m_spots.has_t() && counts_frames(m_spots.time_unit);
    std::optional<double> unit = stated;
    if (!m_options.time_unit.empty()) {
      const double asked = time_unit(m_options.time_unit).value_or(1.0);
      if (!m_spots.has_t())
        m_findings.fault(0, fmt::format("{}: there is no column of time; give {}, s from frame to frame",
                                        m_options.say("time-unit"), m_options.say("interval", "S")));
      else if (((stated && *stated != asked) || frames_as_t) && !m_options.recalibrate)
        contradict(fmt::format("{} is in {}", m_spots.columns.t, excerpt(m_spots.time_unit, 20)),
                   m_options.say("time-unit", m_options.time_unit));
      unit = asked;
    } else if (frames_as_t) {
      return frames(m_spots.has_frames());
    }
    if (!m_spots.has_t()) return frames(true);
    return m_spots.has_frames() ? of_both(unit) : of_t(unit);
  }

  /// Times are the numbers of frames, in their own column or in that of time.
  Time frames(bool own_column) {
    const std::string& name = own_column ? m_spots.columns.frame : m_spots.columns.t;
    if (!m_options.interval)
      m_findings.fault(0, fmt::format("its times are numbers of frames ({}): give {}, s from frame to frame", name,
                                      m_options.say("interval", "S")));
    if (const double step = own_column ? m_frame_step : m_t_step; step > 1.0 && m_options.interval)
      m_findings.note(fmt::format("{} rises by {:g} from position to position: positions are every {:g} s", name, step,
                                  step * *m_options.interval));
    return {own_column, m_options.interval.value_or(1.0)};
  }

  /// The movie was not calibrated: one second from frame to frame is what TrackMate writes if it knows none.
  bool is_uncalibrated(std::optional<double> unit) const {
    return m_t_is_frame && !length_unit(m_spots.length_unit) && (!unit || *unit == 1.0);
  }

  Time of_both(std::optional<double> unit) {
    const auto& [track, t, frame, x, y, made_up, measured, group] = m_spots.columns;
    if (!m_options.interval) {
      if (!unit)
        m_findings.fault(0, fmt::format("does not state the unit of {}: give {}, or {}, s from {} to {}", t,
                                        m_options.say("time-unit", unit_example()), m_options.say("interval", "S"),
                                        frame, frame));
      else if (m_options.time_unit.empty() && is_uncalibrated(unit))
        m_findings.fault(
            0, fmt::format("its movie was not calibrated: x is in no unit of length, and a frame lasts 1 s ({}): give "
                           "{}, s from frame to frame, or {} if it is 1 s",
                           t, m_options.say("interval", "S"),
                           m_options.say("time-unit", m_options.spelling == Spelling::keys ? "\"s\"" : "s")));
      return {false, unit.value_or(1.0)};
    }
    const double interval = *m_options.interval;
    const bool agrees = unit ? about(m_t_per_frame * *unit, interval) : is_some_unit(interval);
    if (agrees || m_options.recalibrate || m_t_per_frame <= 0.0) {
      m_findings.note(fmt::format("times are {} x {:g} s; {} is not used", frame, interval, t));
    } else if (is_uncalibrated(unit) || (!unit && m_t_is_frame)) {
      m_findings.note(
          fmt::format("the movie was not calibrated ({} counts frames): times are {} x {:g} s", t, frame, interval));
    } else if (unit) {
      contradict(fmt::format("{} says {:.6g} s from frame to frame", t, m_t_per_frame * *unit),
                 m_options.say("interval", fmt::format("{:g}", interval)));
    } else {
      m_findings.fault(
          0, fmt::format(
                 "{} rises by {:.6g} from frame to frame, which is {:g} s in no unit of time: give {} and no {}, or "
                 "add {} if {} is wrong",
                 t, m_t_per_frame, interval, m_options.say("time-unit", unit_example()), m_options.say("interval"),
                 m_options.say("recalibrate", m_options.spelling == Spelling::keys ? "true" : ""), t));
    }
    return frames(true);
  }

  std::string unit_example() const { return m_options.spelling == Spelling::keys ? "\"s\" or \"min\"" : "s (or min)"; }

  bool is_some_unit(double interval) const {
    return std::ranges::any_of(time_units(), [&](const std::string& name) {
      return about(m_t_per_frame * time_unit(name).value_or(0.0), interval);
    });
  }

  /// There is a column of time alone.
  Time of_t(std::optional<double> unit) {
    const std::string& t = m_spots.columns.t;
    if (!m_options.interval) {
      if (!unit)
        m_findings.fault(
            0,
            fmt::format("does not state the unit of {}: give {}{}", t, m_options.say("time-unit", unit_example()),
                        counts() ? fmt::format(", or {} if {} counts frames", m_options.say("interval", "S"), t) : ""));
      return {false, unit.value_or(1.0)};
    }
    const double interval = *m_options.interval;
    if (unit && about(m_t_step * *unit, interval)) return {false, *unit};
    if (!unit && counts()) {
      m_findings.note(fmt::format("{} counts frames: times are {} x {:g} s", t, t, interval));
      return {false, interval};
    }
    if (m_options.recalibrate && m_t_step > 0.0) {
      m_findings.note(
          fmt::format("{} rises by {:g} from position to position; this is taken as {:g} s", t, m_t_step, interval));
      return {false, interval / m_t_step};
    }
    if (unit)
      contradict(fmt::format("{} says {:.6g} s from position to position", t, m_t_step * *unit),
                 m_options.say("interval", fmt::format("{:g}", interval)));
    else
      m_findings.fault(
          0, fmt::format("{} rises by {:g} from position to position, so it counts no frames: give {} instead of {}", t,
                         m_t_step, m_options.say("time-unit", unit_example()), m_options.say("interval")));
    return {false, 1.0};
  }

  /// Whether t can be a number of frames.
  bool counts() const { return m_t_is_whole && m_t_step == 1.0; }

  const Spots& m_spots;
  const TrackOptions& m_options;
  Findings& m_findings;
  double m_t_step = 0.0;
  double m_frame_step = 0.0;
  double m_t_per_frame = 0.0;
  bool m_t_is_frame = false;
  bool m_t_is_whole = false;
};

/// Numbers so large that sums of their squares would overflow are no positions.
void check_bounds(const Spots& spots, Findings& findings) {
  for (const Spot& s : spots.spots) {
    for (const double value : {s.x, s.y})
      if (!(std::abs(value) <= largest_length))
        findings.fault(s.line, fmt::format("a position of {:g} um is out of range; allowed is {:g} um on either side",
                                           value, largest_length));
    if (!(std::abs(s.t) <= largest_time))
      findings.fault(s.line, fmt::format("a time of {:g} s is out of range; allowed is {:g} s", s.t, largest_time));
  }
}

} // namespace

Scales calibrate(Spots& spots, const TrackOptions& options, Findings& findings) {
  const Scales scales = Calibration(spots, options, findings).scales();
  for (Spot& s : spots.spots) {
    s.x *= scales.um_per_unit;
    s.y *= scales.um_per_unit;
    s.t = (scales.by_frame ? s.frame : s.t) * scales.s_per_unit;
  }
  spots.t_digit *= scales.by_frame ? 0.0 : scales.s_per_unit;
  check_bounds(spots, findings);
  return scales;
}

} // namespace matrigrate::tracks
