#include "study_report/drawn_study.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "observe/readout_table.hpp"
#include "observe/readouts.hpp"
#include "statistics/sample.hpp"
#include "store/checkpoint.hpp"
#include "study_plan/names.hpp"
#include "study_results/results.hpp"
#include "tables/cell_tracks.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

/// Lines of several cells are one list, with null between them.
void begin_line(Json& lines) {
  for (Json& column : lines)
    if (column.is_array() && !column.empty()) column.push_back(nullptr);
}

/// Lines of x and y, with null before a line of another cell; null if there are no rows.
Json lines_json(const RowsByRun& all, const std::pair<std::string, std::string>& key) {
  const auto found = all.find(key);
  if (found == all.end()) return {};
  Json lines{{"x_um", Json::array()}, {"y_um", Json::array()}};
  double cell = found->second.front().back();
  for (const std::vector<double>& row : found->second) {
    if (row.size() == 3 && row[2] != cell) begin_line(lines);
    cell = row.back();
    lines["x_um"].push_back(row[0]);
    lines["y_um"].push_back(row[1]);
  }
  return lines;
}

/// The samples that are compared, with the numbers of groups.csv.
Json groups_json(const Study& study, const std::vector<Result>& results, const std::vector<Json>& place) {
  Json list = Json::array();
  for (const ReadOutSample& g : samples(study, results))
    list.push_back(group_json(g.readout, place[g.point], g.moments, g.box));
  return list;
}

constexpr std::size_t most_tracks = 200;
constexpr std::size_t most_positions = 100;

double rounded(double um) { return std::round(100.0 * um) / 100.0; }

void add_track(const tracks::CellTrack& track, Json& json) {
  begin_line(json);
  const std::size_t n = std::min(track.t.size(), most_positions);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = evenly(k, n, track.t.size());
    json["t_s"].push_back(rounded(track.t[i]));
    json["x_um"].push_back(rounded(track.x[i] - track.x[0]));
    json["y_um"].push_back(rounded(track.y[i] - track.y[0]));
  }
}

/// True if a target with these tracks holds at a condition.
bool hold_at(const Study& study, const std::vector<tracks::CellTrack>* tracks, std::size_t condition) {
  return std::ranges::any_of(study.targets, [&](const Target& t) {
    return t.tracks.get() == tracks && (t.at.empty() || std::ranges::find(t.at, condition) != t.at.end());
  });
}

/// At most most_positions of each cell's path, the last one among them.
Json path_json(const std::filesystem::path& folder) {
  const std::vector<tracks::CellTrack> tracks = tracks::cell_tracks(folder);
  if (tracks.empty()) return {};
  Json path{{"x_um", Json::array()}, {"y_um", Json::array()}};
  for (const tracks::CellTrack& track : tracks) {
    begin_line(path);
    const std::size_t n = std::min(track.x.size(), most_positions);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = evenly(k, n, track.x.size());
      path["x_um"].push_back(track.x[i]);
      path["y_um"].push_back(track.y[i]);
    }
  }
  return path;
}

std::string_view status_of(const Standing& standing) {
  if (standing.status == RunState::done || standing.status == RunState::failed) return to_string(standing.status);
  return standing.status == RunState::unfinished ? "running" : "pending";
}

/// The cells where the run ended; nothing if its checkpoint was deleted or is damaged.
Json outline_json(const std::filesystem::path& checkpoint) {
  Json outline{{"x_um", Json::array()}, {"y_um", Json::array()}};
  try {
    const State end = store::read_checkpoint(checkpoint).state;
    for (const Cell& cell : end.cells) {
      begin_line(outline);
      for (const Vec2& x : cell.cortex.x) {
        outline["x_um"].push_back(rounded(x.x()));
        outline["y_um"].push_back(rounded(x.y()));
      }
    }
  } catch (const InputOutputError&) {
    return {};
  }
  return outline;
}

/// The data of a run that do not need its folder.
Json readouts_of_run(const Study& study, const Result& result, const Json& place) {
  Json json{{"id", result.run.hash},
            {"point", place},
            {"replicate", result.run.replicate},
            {"seed", result.run.seed},
            {"status", status_of(result.standing)},
            {"reason", result.standing.reason},
            {"report", nullptr},
            {"readouts", Json::object()},
            {"path", nullptr},
            {"outline", nullptr},
            {"f_adh_rel", Json::array()}};
  if (result.standing.done())
    for (const std::string& name : study.readouts) json["readouts"][name] = result.readouts[readout_column(name)];
  return json;
}

constexpr double path_interval = 600.0; // [s]
constexpr std::size_t replicates_shown = 3;

/// Calls use(result, folder of the run) for the runs that are done, point by point.
template <class Use>
void each_done(const Study& study, const std::vector<Result>& results, const std::filesystem::path& folder,
               const Use& use) {
  for (std::size_t point = 0; point < study.points.size(); ++point)
    for (const Result& r : results)
      if (r.run.point == point && r.standing.done()) use(r, run_folder(folder, r.run));
}

/// Columns of a table of a run.
std::vector<std::vector<double>> columns_of(const std::filesystem::path& file,
                                            std::initializer_list<std::string_view> names) {
  return naming(file, [&] { return store::csv_columns(read_file(file, largest_table), names); });
}

/// Lags of msd.csv, and the mean over the cells at each.
std::pair<std::vector<double>, std::vector<double>> msd_of(const std::filesystem::path& file) {
  const auto columns = columns_of(file, {"lag_s", "msd_um2"});
  const std::vector<double>&lag = columns[0], &msd = columns[1];
  std::map<double, std::vector<double>> at;
  for (std::size_t k = 0; k < lag.size(); ++k)
    if (!std::isnan(lag[k])) at[lag[k]].push_back(msd[k]);
  std::pair<std::vector<double>, std::vector<double>> means;
  for (const auto& [l, values] : at) {
    means.first.push_back(l);
    means.second.push_back(statistics::moments(values).mean);
  }
  return means;
}

} // namespace

std::size_t evenly(std::size_t k, std::size_t chosen, std::size_t n) {
  return chosen < 2 ? 0 : k * (n - 1) / (chosen - 1);
}

Json group_json(std::string_view readout, const Json& place, const statistics::Moments& moments,
                const statistics::Box& box) {
  return {{"readout", readout},
          {"point", place},
          {"n", moments.n},
          {"mean", moments.mean},
          {"low_whisker", box.low_whisker},
          {"low_quartile", box.low_quartile},
          {"median", box.median},
          {"high_quartile", box.high_quartile},
          {"high_whisker", box.high_whisker}};
}

Json interval_json(const statistics::Interval& found) {
  return std::isfinite(found.low) && std::isfinite(found.high) ? Json{found.low, found.high} : Json();
}

Json test_json(const Comparison& c, TestKind test, const std::vector<Json>& places) {
  return {{"readout", c.readout},
          {"a", places[c.a]},
          {"b", places[c.b]},
          {"test", name(test)},
          {"statistic", c.test.statistic},
          {"p", c.test.p},
          {"p_holm", c.p_holm},
          {"n_a", c.sample_a.n},
          {"n_b", c.sample_b.n},
          {"difference", c.difference.value},
          {"interval", interval_json(c.difference)}};
}

Json readouts_json(const Study& study) {
  Json list = Json::array();
  for (const std::string& name : study.readouts) {
    const ReadOutSpec* spec = find_readout(name); // none of those that tables of runs give
    const std::string_view unit = spec == nullptr || spec->unit == "-" ? "" : spec->unit;
    list.push_back({{"name", name},
                    {"label", spec == nullptr ? name : std::string(spec->label)},
                    {"meaning", spec == nullptr ? name : std::string(spec->meaning)},
                    {"unit", unit}});
  }
  return list;
}

Json compared_json(const Study& study, const std::vector<Result>& results, const std::vector<Comparison>& comparisons) {
  const std::vector<Json> place = places(study);
  Json tests = Json::array();
  for (const Comparison& c : comparisons) tests.push_back(test_json(c, study.comparisons.test, place));
  return {{"axes", axes_json(study)},
          {"readouts", readouts_json(study)},
          {"groups", groups_json(study, results, place)},
          {"tests", std::move(tests)}};
}

Json msd_json(const std::vector<MeanMsd>& means, const Json& place) {
  Json json{{"point", place}, {"lag_min", Json::array()}, {"msd_um2", Json::array()}, {"sem_um2", Json::array()}};
  std::vector<MsdPoint> points;
  for (const MeanMsd& m : means) {
    json["lag_min"].push_back(m.lag / 60.0);
    json["msd_um2"].push_back(m.mean);
    json["sem_um2"].push_back(m.sem);
    points.push_back({.lag = m.lag, .msd = m.mean, .samples = m.runs});
  }
  json["slope"] = msd_slope(points);
  return json;
}

Json drawn_study(const Study& study, const std::vector<Result>& results, const CurveTables& tables) {
  const auto rows = [](const char* name, const std::string& table, const std::vector<std::string_view>& columns) {
    return table.empty() ? RowsByRun() : naming(name, [&] { return rows_by_run(table, columns); });
  };
  const RowsByRun paths = rows("paths.csv", tables.paths, {"x_um", "y_um"});
  const RowsByRun shapes = rows("shapes.csv", tables.shapes, {"x_um", "y_um"});
  const RowsByRun adhesions = rows("adhesions.csv", tables.adhesions, {"f_adh_rel"});
  RowsByRun msds = rows("msd.csv", tables.msd, {"lag_s", "msd_um2", "sem_um2", "n_runs"});
  const std::vector<Json> place = places(study);
  Json data{{"title", study.title}};
  data.update(compared_json(study, results, comparisons(study, results)));
  data["runs"] = Json::array();
  for (const Result& r : results) {
    const std::pair<std::string, std::string> key{study.points[r.run.point].label, fmt::to_string(r.run.replicate)};
    Json run = readouts_of_run(study, r, place[r.run.point]);
    run["path"] = lines_json(paths, key);
    run["outline"] = lines_json(shapes, key);
    if (const auto found = adhesions.find(key); found != adhesions.end())
      for (const std::vector<double>& row : found->second) run["f_adh_rel"].push_back(row[0]);
    data["runs"].push_back(std::move(run));
  }
  data["msd"] = Json::array();
  for (std::size_t point = 0; point < place.size(); ++point) {
    std::vector<MeanMsd> means;
    for (const std::vector<double>& row : msds[{study.points[point].label, ""}])
      means.push_back({row[0], row[1], row[2], static_cast<std::size_t>(row[3])});
    if (!means.empty()) data["msd"].push_back(msd_json(means, place[point]));
  }
  return data;
}

Json measured_json(const std::vector<tracks::CellTrack>& tracks) {
  if (tracks.empty()) return {};
  Json json{{"total", tracks.size()}, {"t_s", Json::array()}, {"x_um", Json::array()}, {"y_um", Json::array()}};
  const std::size_t n = std::min(tracks.size(), most_tracks);
  for (std::size_t k = 0; k < n; ++k) add_track(tracks[evenly(k, n, tracks.size())], json);
  return json;
}

std::vector<tracks::CellTrack> tracks_at(const Study& study, const std::vector<tracks::CellTrack>& further,
                                         std::size_t point) {
  std::vector<tracks::CellTrack> all = further;
  for (const auto& set : measured_sets(study))
    if (hold_at(study, set.get(), study.points[point].condition)) std::ranges::copy(*set, std::back_inserter(all));
  return all;
}

Json measured_json(const Study& study, const std::vector<tracks::CellTrack>& further, const std::vector<Json>& places) {
  Json list = Json::array();
  if (!further.empty()) {
    list.push_back(measured_json(further));
    list.back()["points"] = places;
  }
  for (const auto& set : measured_sets(study)) {
    list.push_back(measured_json(*set));
    list.back()["points"] = Json::array();
    for (std::size_t i = 0; i < places.size(); ++i)
      if (hold_at(study, set.get(), study.points[i].condition)) list.back()["points"].push_back(places[i]);
  }
  return list;
}

Json run_json(const Study& study, const std::filesystem::path& study_folder, const Result& result, const Json& place) {
  const std::filesystem::path folder = run_folder(study_folder, result.run);
  Json json = readouts_of_run(study, result, place);
  std::error_code error;
  if (std::filesystem::exists(folder / "report.html", error))
    json["report"] = (folder.lexically_relative(study_folder) / "report.html").generic_string();
  if (!result.standing.done()) return json;
  json["path"] = path_json(folder);
  json["outline"] = outline_json(folder / store::checkpoint_name);
  for (const double force : store::csv_column(read_file(folder / "protrusions.csv", largest_table), "f_adh_rel"))
    if (std::isfinite(force)) json["f_adh_rel"].push_back(force);
  return json;
}

std::vector<MeanMsd> mean_msd(const std::vector<Result>& results, std::size_t point,
                              const std::filesystem::path& study_folder) {
  std::vector<double> lags;
  std::vector<std::vector<double>> runs;
  for (const Result& result : results) {
    if (result.run.point != point || !result.standing.done()) continue;
    const auto [here, msd] = msd_of(run_folder(study_folder, result.run) / "msd.csv");
    if (runs.empty() || here.size() < lags.size()) lags = here;
    runs.push_back(msd);
  }
  std::vector<MeanMsd> means;
  for (std::size_t k = 0; k < lags.size(); ++k) {
    std::vector<double> values;
    for (const std::vector<double>& run : runs) values.push_back(run[k]);
    const statistics::Moments m = statistics::moments(values);
    means.push_back({lags[k], m.mean, m.sd / std::sqrt(static_cast<double>(values.size())), values.size()});
  }
  return means;
}

std::string paths_csv(const Study& study, const std::vector<Result>& results,
                      const std::filesystem::path& study_folder) {
  const bool several = has_several_cells(study);
  std::string csv = fmt::format("replicate,t_s,x_um,y_um,{}point\n", several ? "cell," : "");
  each_done(study, results, study_folder, [&](const Result& r, const std::filesystem::path& folder) {
    for (const auto& [cell, t, x, y] : tracks::cell_tracks(folder))
      for (std::size_t k = 0; k < t.size(); ++k) {
        if (std::abs(std::remainder(t[k], path_interval)) > 1e-6) continue;
        csv += fmt::format("{},{:.0f},{:.2f},{:.2f},{}{}\n", r.run.replicate, t[k], x[k] - x[0], y[k] - y[0],
                           several ? fmt::format("{},", cell) : "", csv_text(study.points[r.run.point].label));
      }
  });
  return csv;
}

std::string msd_csv(const Study& study, const std::vector<Result>& results, const std::filesystem::path& study_folder) {
  std::string csv = "lag_s,msd_um2,sem_um2,n_runs,point\n";
  for (std::size_t point = 0; point < study.points.size(); ++point)
    for (const MeanMsd& m : mean_msd(results, point, study_folder))
      csv += fmt::format("{:.0f},{:.4g},{},{},{}\n", m.lag, m.mean,
                         std::isfinite(m.sem) ? fmt::format("{:.4g}", m.sem) : std::string(), m.runs,
                         csv_text(study.points[point].label));
  return csv;
}

std::string adhesions_csv(const Study& study, const std::vector<Result>& results,
                          const std::filesystem::path& study_folder) {
  std::string csv = "replicate,length_um,f_mat,f_adh_rel,point\n";
  each_done(study, results, study_folder, [&](const Result& r, const std::filesystem::path& folder) {
    const auto columns = columns_of(folder / "protrusions.csv", {"length_um", "f_mat", "f_adh_rel"});
    const std::vector<double>&length = columns[0], &f_mat = columns[1], &force = columns[2];
    for (std::size_t k = 0; k < force.size(); ++k)
      if (std::isfinite(force[k]))
        csv += fmt::format("{},{:.2f},{:.3f},{:.3f},{}\n", r.run.replicate, length[k], f_mat[k], force[k],
                           csv_text(study.points[r.run.point].label));
  });
  return csv;
}

std::string shapes_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder) {
  std::string csv = "replicate,x_um,y_um,point\n";
  for (const Result& r : results) {
    if (!r.standing.done() || r.run.replicate > replicates_shown) continue;
    const std::filesystem::path checkpoint = run_folder(study_folder, r.run) / store::checkpoint_name;
    if (!std::filesystem::exists(checkpoint)) continue;
    const CortexState cortex = store::read_checkpoint(checkpoint).state.cells.at(0).cortex;
    for (std::size_t i = 0; i < cortex.size(); i += 2)
      csv += fmt::format("{},{:.2f},{:.2f},{}\n", r.run.replicate, cortex.x[i].x(), cortex.x[i].y(),
                         csv_text(study.points[r.run.point].label));
  }
  return csv;
}

} // namespace matrigrate::study
