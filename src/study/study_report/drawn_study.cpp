#include "study_report/drawn_study.hpp"

#include "observe/displacement_statistics.hpp"
#include "observe/readout_table.hpp"
#include "study_plan/names.hpp"
#include "study_report/run_json.hpp"
#include "study_results/read_results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>
#include <utility>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

/// Lines of x and y, with null before a line of another cell; null if there are no rows.
Json lines_json(const RowsByRun& all, const std::pair<std::string, std::string>& key) {
  const auto found = all.find(key);
  if (found == all.end()) return {};
  Json lines{{"x_um", Json::array()}, {"y_um", Json::array()}};
  double cell = found->second.front().back();
  for (const std::vector<double>& row : found->second) {
    if (row.size() == 3 && row[2] != cell)
      for (const char* axis : {"x_um", "y_um"}) lines[axis].push_back(nullptr);
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
    list.push_back({{"readout", g.readout},
                    {"point", place[g.point]},
                    {"n", g.moments.n},
                    {"mean", g.moments.mean},
                    {"low_whisker", g.box.low_whisker},
                    {"low_quartile", g.box.low_quartile},
                    {"median", g.box.median},
                    {"high_quartile", g.box.high_quartile},
                    {"high_whisker", g.box.high_whisker}});
  return list;
}

Json test_json(const Study& study, const Comparison& c, const std::vector<Json>& place) {
  const bool bounded = std::isfinite(c.difference.low) && std::isfinite(c.difference.high);
  return {{"readout", c.readout},
          {"a", place[c.a]},
          {"b", place[c.b]},
          {"test", name(study.comparisons.test)},
          {"statistic", c.test.statistic},
          {"p", c.test.p},
          {"p_holm", c.p_holm},
          {"n_a", c.sample_a.n},
          {"n_b", c.sample_b.n},
          {"difference", c.difference.value},
          {"interval", bounded ? Json{c.difference.low, c.difference.high} : Json()}};
}

} // namespace

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
  for (const Comparison& c : comparisons) tests.push_back(test_json(study, c, place));
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
  const RowsByRun paths = rows_by_run(tables.paths, {"x_um", "y_um"});
  const RowsByRun shapes = rows_by_run(tables.shapes, {"x_um", "y_um"});
  const RowsByRun adhesions = rows_by_run(tables.adhesions, {"f_adh_rel"});
  RowsByRun msds = rows_by_run(tables.msd, {"lag_s", "msd_um2", "sem_um2", "n_runs"});
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

} // namespace matrigrate::study
