#include "study_report/beside.hpp"

#include "base/failure.hpp"
#include "base/random.hpp"
#include "report/run_page.hpp"
#include "statistics/compare.hpp"
#include "statistics/sample.hpp"
#include "study_report/drawn_study.hpp"
#include "study_runs/study_folder.hpp"
#include "tables/cell_tracks.hpp"
#include "tables/state_json.hpp"
#include "tracks/readouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

constexpr std::size_t most_points = 12; // of a study on one page
constexpr double confidence = 0.95;
constexpr std::uint64_t error_key = 1; // of the errors that are drawn
/// Read-outs that a single track has, and what stands on the axis of each.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> shown{{
    {"speed_um_per_h", "speed from position to position"},
    {"v_migr_abs_um_per_h", "speed from start to end"},
    {"straightness", "distance over length of path, from start to end"},
    {"directionality_ratio", "distance over length of path, of windows of ten intervals"},
    {"turning_angle_deg", "angle between successive steps"},
}};

[[noreturn]] void refuse(const std::string& place, const std::string& reason) {
  throw ConfigurationError({{place, 0, 0, {}, reason}});
}

/// Two independent draws of a normal distribution (Box and Muller 1958).
std::array<double, 2> normal_pair(std::uint32_t track, std::uint64_t position) {
  const double size = std::sqrt(-2.0 * std::log(uniform(error_key, Purpose::sampling, position, track, 0)));
  const double angle = 2.0 * std::numbers::pi * uniform(error_key, Purpose::sampling, position, track, 1);
  return {size * std::cos(angle), size * std::sin(angle)};
}

/// Adds the cells of a run at the interval of its table.
void add_cells(const std::filesystem::path& run_folder, const std::string& name, tracks::Tracks& all) {
  for (const tracks::CellTrack& cell : tracks::cell_tracks(run_folder)) {
    if (cell.t.size() < 3) continue;
    const double step = cell.t[1] - cell.t[0];
    if (all.tracks.empty()) all.interval = step;
    if (std::abs(step / all.interval - 1.0) > 0.01)
      refuse(run_folder.string(),
             fmt::format("its tracks have a row every {:g} s, others every {:g} s", step, all.interval));
    tracks::Track track{
        .name = fmt::format("{}, cell {}", name, cell.cell), .start = cell.t[0], .k = {}, .x = {}, .y = {}};
    for (std::size_t i = 0; i < cell.t.size(); ++i) {
      const double place = (cell.t[i] - cell.t[0]) / step;
      if (std::abs(place - std::round(place)) > 0.01) continue; // the run ended between two rows
      track.k.push_back(static_cast<std::size_t>(std::round(place)));
      track.x.push_back(cell.x[i]);
      track.y.push_back(cell.y[i]);
    }
    all.tracks.push_back(std::move(track));
  }
}

/// As the microscope sees them.
tracks::Tracks seen(const tracks::Tracks& all, const Microscope& microscope, const std::string& folder) {
  tracks::Tracks cells = tracks::at_interval(all, microscope.interval, folder);
  const std::size_t last = cut(cells, microscope.duration);
  std::uint32_t number = 0;
  for (tracks::Track& track : cells.tracks) {
    for (std::size_t i = 0; microscope.error > 0.0 && i < track.k.size(); ++i) {
      const auto [dx, dy] = normal_pair(number, track.k[i]);
      track.x[i] += microscope.error * dx;
      track.y[i] += microscope.error * dy;
    }
    ++number;
  }
  const std::size_t all_tracks = cells.tracks.size();
  const auto shorter =
      std::ranges::count_if(cells.tracks, [&](const tracks::Track& track) { return track.span() < last; });
  cells.notes.clear();
  if (shorter > 0)
    cells.notes.push_back(fmt::format("{} of {} simulated paths are shorter than {:g} min", shorter, all_tracks,
                                      microscope.duration / 60.0));
  std::erase_if(cells.tracks, [](const tracks::Track& track) { return track.k.size() < 3; });
  return cells;
}

std::size_t column_of(std::string_view readout) {
  const auto found = std::ranges::find(tracks::track_readouts, readout, &tracks::ReadoutMeaning::name);
  return static_cast<std::size_t>(found - tracks::track_readouts.begin());
}

/// A read-out of each track of a group.
std::vector<double> of_each(const tracks::TrackParts& parts, std::string_view readout) {
  const std::size_t r = column_of(readout);
  std::vector<double> values;
  for (std::size_t i = 0; i < parts.size(); ++i) values.push_back(parts.readouts(std::array{i}, 0.0)[r]);
  return values;
}

statistics::Interval median_interval(const std::vector<double>& x, std::uint64_t key) {
  std::vector<double> draws;
  for (std::size_t draw = 0; draw < statistics::bootstrap_draws; ++draw)
    draws.push_back(statistics::quantile(statistics::picked(x, statistics::resampled(x.size(), key, draw)), 0.5));
  return statistics::percentile_interval(statistics::quantile(x, 0.5), draws, 1.0 - confidence);
}

/// Each pair of groups in one read-out.
std::vector<Comparison> pairs_in(std::string_view readout, const std::vector<std::vector<double>>& samples) {
  std::vector<Comparison> pairs;
  std::vector<double> p;
  for (std::size_t b = 0; b < samples.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const std::vector<double>&x = samples[a], &y = samples[b];
      pairs.push_back({.readout = std::string(readout),
                       .a = a,
                       .b = b,
                       .sample_a = statistics::moments(x),
                       .sample_b = statistics::moments(y),
                       .difference = statistics::mean_difference(x, y, 1.0 - confidence, false),
                       .test = statistics::mann_whitney_test(x, y)});
      p.push_back(pairs.back().test.p);
    }
  const std::vector<double> holm = statistics::holm(p);
  for (std::size_t i = 0; i < holm.size(); ++i) pairs[i].p_holm = holm[i];
  return pairs;
}

/// Mean square displacement at lags to half the longest track, with the standard error over sets of tracks.
Json msd_of_group(const tracks::TrackParts& parts, double interval, std::size_t place) {
  const std::vector<double> msd = parts.msd();
  const std::size_t lags = msd.size() / 2;
  std::vector<std::vector<double>> draws(lags);
  for (std::size_t draw = 0; draw < 200; ++draw) {
    const std::vector<double> one = parts.msd(statistics::resampled(parts.size(), place + 1, draw));
    for (std::size_t k = 0; k < lags && k < one.size(); ++k) draws[k].push_back(one[k]);
  }
  std::vector<MeanMsd> means;
  const std::size_t step = std::max<std::size_t>(1, lags / 40); // as many points as can be told apart
  for (std::size_t k = 0; k < lags; k += step)
    if (std::isfinite(msd[k]))
      means.push_back({.lag = interval * static_cast<double>(k + 1),
                       .mean = msd[k],
                       .sem = statistics::moments(statistics::finite(draws[k])).sd});
  Json json = msd_json(means, Json::array({place}));
  json["slope"] = parts.readouts(0.0)[column_of("msd_slope_long")];
  return json;
}

Json readouts_shown() {
  Json list = Json::array();
  for (const auto& [name, meaning] : shown)
    list.push_back({{"name", name},
                    {"label", meaning},
                    {"meaning", meaning},
                    {"unit", tracks::track_readouts[column_of(name)].unit}});
  return list;
}

Json track_json(const CellGroup& group, const tracks::Track& track, std::size_t place) {
  Json path{{"x_um", Json::array()}, {"y_um", Json::array()}};
  for (std::size_t i = 0; i < track.k.size(); ++i) {
    path["x_um"].push_back(std::round(100.0 * (track.x[i] - track.x[0])) / 100.0);
    path["y_um"].push_back(std::round(100.0 * (track.y[i] - track.y[0])) / 100.0);
  }
  return {{"id", fmt::format("{}: {}", group.label, track.name)},
          {"name", track.name},
          {"point", Json::array({place})},
          {"seed", 0},
          {"status", "done"},
          {"reason", ""},
          {"report", nullptr},
          {"readouts", Json::object()},
          {"path", std::move(path)}};
}

/// "Speed from position to position, median: control 12.1 [10, 14] um/h, ..."
std::string summary(const std::vector<CellGroup>& groups, const std::vector<std::vector<double>>& speeds) {
  std::vector<std::string> medians;
  for (std::size_t place = 0; place < groups.size(); ++place) {
    const statistics::Interval median = median_interval(speeds[place], place + 1);
    medians.push_back(
        fmt::format("{} {:.3g} [{:.3g}, {:.3g}]", groups[place].label, median.value, median.low, median.high));
  }
  return fmt::format("Median of the {} [95 % interval], um/h: {}.", shown.front().second, fmt::join(medians, "; "));
}

Json facts_json(const Microscope& microscope) {
  return {
      {{"name", "interval"}, {"value", fmt::format("{:g} s", microscope.interval)}},
      {{"name", "duration of paths"},
       {"value", fmt::format("at most {:g} min, which half of the measured tracks reach", microscope.duration / 60.0)}},
      {{"name", "localisation error"},
       {"value", fmt::format("{:g} um, added to simulated coordinates", microscope.error)}}};
}

/// How many runs are not done, and what those at the rim mean; empty if all are done.
std::string notes_of_lost(const Study& study, const std::vector<Result>& all) {
  const auto lost = std::ranges::count_if(all, [](const Result& r) { return !r.standing.done(); });
  if (lost == 0) return {};
  const std::string rim = rim_text(study, all);
  return fmt::format("{} of {} runs are not done, and left out{}{}", lost, all.size(), rim.empty() ? "" : "; ", rim);
}

} // namespace

std::size_t cut(tracks::Tracks& cells, double duration) {
  const auto last = static_cast<std::size_t>(std::round(duration / cells.interval));
  for (tracks::Track& track : cells.tracks) {
    const auto kept = static_cast<std::size_t>(std::ranges::upper_bound(track.k, last) - track.k.begin());
    for (auto* const column : {&track.x, &track.y}) column->resize(kept);
    track.k.resize(kept);
  }
  return last;
}

std::vector<CellGroup> simulated_cells(const std::filesystem::path& folder, const Microscope& microscope) {
  std::vector<CellGroup> groups;
  std::string notes;
  const std::string name = folder.lexically_normal().string();
  if (!std::filesystem::exists(folder / "study.resolved.toml")) {
    CellGroup& group = groups.emplace_back(CellGroup{.label = "model", .tracks = {}});
    if (const std::string status =
            store::read_json_object(folder / "run.json", std::size_t{1} << 24).value("status", "");
        status != "done")
      refuse(name, fmt::format("its run is {}, not done", status.empty() ? "without a status" : status));
    add_cells(folder, "run", group.tracks);
  } else {
    const StudyFolder study = open_study(folder);
    if (study.study.points.size() > most_points)
      refuse(name, fmt::format("has {} points; a page shows at most {}: name a study of fewer",
                               study.study.points.size(), most_points));
    for (const Point& point : study.study.points)
      groups.push_back({.label = study.study.points.size() == 1 ? "model" : "model, " + point.label, .tracks = {}});
    const std::vector<Result> all = results(study.study, study.runs, folder);
    notes = notes_of_lost(study.study, all);
    for (const Result& r : all)
      if (r.standing.done())
        add_cells(run_folder(folder, r.run), fmt::format("seed {}", r.run.seed), groups[r.run.point].tracks);
  }
  const auto is_empty = [](const CellGroup& group) { return group.tracks.tracks.empty(); };
  std::erase_if(groups, is_empty);
  for (CellGroup& group : groups) group.tracks = seen(group.tracks, microscope, name + ": output.track_interval");
  std::erase_if(groups, is_empty);
  if (!groups.empty() && !notes.empty()) groups.front().tracks.notes.push_back(notes);
  if (groups.empty()) refuse(name, "has no run that is done and lasts three positions of the measured tracks");
  return groups;
}

double usual_duration(const std::vector<CellGroup>& groups) {
  std::vector<double> spans;
  for (const CellGroup& group : groups)
    for (const tracks::Track& track : group.tracks.tracks)
      spans.push_back(static_cast<double>(track.span()) * group.tracks.interval);
  return statistics::quantile(spans, 0.5);
}

void require_comparable(const std::vector<CellGroup>& groups) {
  std::vector<Fault> faults;
  for (std::size_t b = 0; b < groups.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const tracks::Tracks &one = groups[a].tracks, &other = groups[b].tracks;
      if (std::abs(one.interval / other.interval - 1.0) > 0.01)
        faults.push_back(
            {groups[b].label,
             0,
             0,
             {},
             fmt::format("has a position every {:g} s, {} every {:g} s; --every brings both to one interval",
                         other.interval, groups[a].label, one.interval)});
      if (std::ranges::equal(one.tracks, other.tracks,
                             [](const auto& p, const auto& q) { return p.x == q.x && p.y == q.y; }))
        faults.push_back({groups[b].label, 0, 0, {}, fmt::format("has the same positions as {}", groups[a].label)});
    }
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
}

Json beside_data(const std::vector<CellGroup>& groups, const Microscope& microscope) {
  Json labels = Json::array(), runs = Json::array(), msd = Json::array(), boxes = Json::array(), tests = Json::array();
  std::map<std::string_view, std::vector<std::vector<double>>> samples;
  std::vector<Json> places;
  for (std::size_t place = 0; place < groups.size(); ++place) {
    const CellGroup& group = groups[place];
    const tracks::TrackParts parts(group.tracks);
    labels.push_back(group.label);
    places.push_back(Json::array({place}));
    const std::size_t first = runs.size();
    for (const tracks::Track& track : group.tracks.tracks) runs.push_back(track_json(group, track, place));
    for (const auto& [name, meaning] : shown) {
      const std::vector<double> values = of_each(parts, name);
      for (std::size_t i = 0; i < values.size(); ++i) runs[first + i]["readouts"][std::string(name)] = values[i];
      samples[name].push_back(statistics::finite(values));
      const std::vector<double>& x = samples[name].back();
      boxes.push_back(group_json(name, places.back(), statistics::moments(x), statistics::box(x)));
      boxes.back()["median_interval"] = interval_json(median_interval(x, place + 1));
    }
    msd.push_back(msd_of_group(parts, group.tracks.interval, place));
  }
  for (const auto& [name, meaning] : shown)
    for (const Comparison& c : pairs_in(name, samples[name]))
      tests.push_back(test_json(c, TestKind::mann_whitney, places));
  const Json axis{{"name", "cells"}, {"label", "cells"}, {"meaning", "cells"}, {"unit", ""}, {"values", labels}};
  std::vector<std::string> names, counts;
  for (const CellGroup& group : groups) {
    names.push_back(group.label);
    counts.push_back(fmt::format("{} of {}", group.tracks.tracks.size(), group.label));
  }
  return {{"format", "matrigrate-study"},
          {"version", 1},
          {"sampled", "tracks"},
          {"title", fmt::format("Cells: {}", fmt::join(names, ", "))},
          {"status", fmt::format("Tracks: {}.", fmt::join(counts, ", "))},
          {"summary", summary(groups, samples[shown.front().first])},
          {"facts", facts_json(microscope)},
          {"axes", Json::array({axis})},
          {"readouts", readouts_shown()},
          {"runs", runs},
          {"groups", boxes},
          {"tests", tests},
          {"msd", msd},
          {"provenance", ""},
          {"citation", report::citation()}};
}

} // namespace matrigrate::study
