#include "parameters/document.hpp"
#include "statistics/sample.hpp"
#include "tracks/read_tracks.hpp"
#include "tracks/spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace matrigrate::tracks {

namespace {

constexpr double long_one = 3.0, very_far = 10.0; ///< over the usual step

struct Found {
  Step step;
  const Track* track;
  std::size_t from, to; ///< intervals since the first start
};

std::vector<Found> steps_of(const Tracks& tracks) {
  const double first = tracks.first();
  std::vector<Found> steps;
  for (const Track& track : tracks.tracks) {
    const std::size_t offset = tracks.offset(track, first);
    for (std::size_t i = 1; i < track.k.size(); ++i)
      steps.push_back({.step = {.dx = track.x[i] - track.x[i - 1],
                                .dy = track.y[i] - track.y[i - 1],
                                .gap = static_cast<double>(track.k[i] - track.k[i - 1])},
                       .track = &track,
                       .from = offset + track.k[i - 1],
                       .to = offset + track.k[i]});
  }
  return steps;
}

bool leaps_alone(const Found& found, double usual) {
  return std::hypot(found.step.dx, found.step.dy) > very_far * usual * found.step.gap;
}

/// The steps across each time at which one is long.
std::map<std::size_t, std::vector<Step>> across_long_ones(const std::vector<Found>& steps, double usual) {
  std::map<std::size_t, std::vector<Step>> across;
  for (const Found& one : steps)
    if (one.step.length() > very_far * usual) across.try_emplace(one.from);
  for (const Found& one : steps)
    for (auto at = across.lower_bound(one.from); at != across.end() && at->first < one.to; ++at)
      at->second.push_back(one.step);
  return across;
}

void tell_together(const std::vector<Step>& steps, Together kind, double time, double usual,
                   const TrackOptions& options, Findings& findings) {
  std::vector<double> lengths, gaps;
  for (const Step& step : steps) {
    lengths.push_back(std::hypot(step.dx, step.dy));
    gaps.push_back(step.gap);
  }
  const auto [least, most] = std::ranges::minmax(lengths);
  const std::string what =
      fmt::format("after {:g} s all {} tracks that go on leap, by {:.3g} to {:.3g} um (the usual step is {:.3g} um)",
                  time, steps.size(), least, most, usual);
  if (kind == Together::shifts)
    return findings.note("{}, and all alike: did the stage move? {} takes it away", what, options.say("drift", "true"));
  const bool none = std::ranges::find(options.columns.group, "none") != options.columns.group.end();
  if (none || std::ranges::max(gaps) > 1.0) return findings.note(what + ": is it another movie?");
  findings.fault(0,
                 "{}: another movie begins. Tell movies apart by a column, {}, or read each by itself; {} if these are "
                 "the same cells",
                 what, options.say("columns", "group=NAME"), options.say("columns", "group=none"));
}

} // namespace

double Step::length() const { return std::hypot(dx, dy) / std::sqrt(gap); }

double usual_step(std::span<const Step> steps) {
  std::vector<double> lengths;
  for (const Step& step : steps)
    if (step.gap < 1.5 && step.length() > 0.0) lengths.push_back(step.length());
  return lengths.empty() ? 0.0 : statistics::quantile(lengths, 0.5);
}

Together together(std::span<const Step> steps, double usual, bool sure) {
  if (steps.size() < 2 || !(usual > 0.0)) return Together::walks;
  const bool half = sure && std::ranges::all_of(steps, [](const Step& step) { return step.gap < 1.5; });
  const double least = (half ? 0.5 : 1.0) * very_far * usual;
  const auto n = static_cast<double>(steps.size());
  std::vector<double> lengths;
  double x = 0.0, y = 0.0, square = 0.0;
  for (const Step& step : steps) {
    lengths.push_back(step.length());
    x += step.dx / n;
    y += step.dy / n;
  }
  const auto long_ones = std::ranges::count_if(lengths, [&](double one) { return one > least * long_one / very_far; });
  if (static_cast<double>(long_ones) < 0.9 * n || !(statistics::quantile(lengths, 0.5) > least)) return Together::walks;
  for (const Step& step : steps) square += (std::pow(step.dx - x, 2) + std::pow(step.dy - y, 2)) / step.gap / n;
  return std::sqrt(square) <= long_one * usual ? Together::shifts : Together::leaps;
}

void look_for_leaps(const Tracks& tracks, const TrackOptions& options, Findings& findings) {
  const std::vector<Found> found = steps_of(tracks);
  std::vector<Step> steps;
  for (const Found& one : found) steps.push_back(one.step);
  const double usual = usual_step(steps);
  if (!(usual > 0.0)) return;
  const double first = tracks.first();
  const auto is_long = [&](const Step& step) { return step.length() > long_one * usual; };
  const auto all_long = std::ranges::count_if(steps, is_long);
  const auto times = static_cast<double>(std::ranges::max_element(found, {}, &Found::to)->to);
  bool together_once = false;
  for (const auto& [k, across] : across_long_ones(found, usual)) {
    const Together kind = together(across, usual);
    // Where long steps are frequent, they fall together by chance.
    const double others = static_cast<double>(all_long - std::ranges::count_if(across, is_long));
    const double share = others / static_cast<double>(std::max<std::size_t>(1, found.size() - across.size()));
    if (kind == Together::walks || std::pow(share, static_cast<double>(across.size())) * times > 0.05) continue;
    tell_together(across, kind, first + static_cast<double>(k) * tracks.interval, usual, options, findings);
    together_once = true;
  }
  if (together_once) return;
  const auto alone =
      static_cast<std::size_t>(std::ranges::count_if(found, [&](const Found& one) { return leaps_alone(one, usual); }));
  if (alone == 0 || 10 * alone > found.size()) return;
  const auto length = [](const Found& one) { return std::hypot(one.step.dx, one.step.dy); };
  const Found& longest = *std::ranges::max_element(found, {}, length);
  findings.note("{} over ten times the usual one, {:.3g} um; the longest, {:.3g} um, is of track {} at {:g} s: a wrong "
                "link, or another movie?",
                counted(alone, "step") + (alone == 1 ? " is" : " are"), usual, length(longest),
                excerpt(longest.track->name, 40), first + static_cast<double>(longest.to) * tracks.interval);
}

} // namespace matrigrate::tracks
