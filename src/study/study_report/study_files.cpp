#include "study_report/study_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "claims/claims.hpp"
#include "parameters/schema.hpp"
#include "report/run_page.hpp"
#include "run/finished_run.hpp"
#include "run/folder_state.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "statistics/correlation.hpp"
#include "study_plan/names.hpp"
#include "study_plan/settings.hpp"
#include "study_report/drawn_study.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <system_error>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json; // NaN is written as null

/// The command that computes the study again, from the file in its folder.
std::string command_of(const StudyFolder& study) {
  const std::filesystem::path name = full_path(study.folder).filename();
  return run::command_text({"matrigrate", "study", "run", (name / "study.resolved.toml").string()});
}

/// Where a point has enough runs.
Json correlation_json(const Study& study, const std::vector<Result>& results) {
  std::map<std::size_t, std::size_t> runs; // at each point
  std::size_t most = 0;
  for (const Result& r : results)
    if (r.standing.done()) most = std::max(most, ++runs[r.run.point]);
  const Correlations found = correlations(study, results);
  if (most < least_runs || found.readouts.size() < 2) return {};
  Json r = Json::array(), p = Json::array(), n = Json::array();
  for (const auto& row : found.pairs) {
    for (Json* matrix : {&r, &p, &n}) matrix->push_back(Json::array());
    for (const statistics::Correlation& c : row) {
      r.back().push_back(c.r);
      p.back().push_back(c.p);
      n.back().push_back(c.n);
    }
  }
  return {{"names", found.readouts}, {"r", r}, {"p", p}, {"p_holm", found.p_holm}, {"n", n}};
}

/// Read-outs over factors where the points are no grid: values of numbers in the unit of their row, one a point, and
/// for each read-out Spearman's correlation of the means of points, with p after Holm over all of them.
Json scatter_json(const Study& study, const std::vector<Result>& results) {
  const Json axes = axes_json(study);
  if (axes.empty() || (axes.at(0).at("name") != "point" && axes.at(0).at("name") != "factors")) return {};
  const std::vector<ReadOutSample> means = samples(study, results);
  Json factors = Json::array();
  std::vector<double> all_p;
  for (const std::string& key : swept_keys(study)) {
    const Row& row = *find_row(key, study.base);
    std::vector<double> values;
    for (const Point& point : study.points)
      if (const auto value = number_in_unit(row, point.parameters)) values.push_back(*value);
    if (values.size() != study.points.size() || std::ranges::min(values) == std::ranges::max(values)) continue;
    Json correlations = Json::array();
    for (const std::string& readout : study.readouts) {
      std::vector<double> y(values.size(), std::numeric_limits<double>::quiet_NaN());
      for (const ReadOutSample& s : means)
        if (s.readout == readout) y[s.point] = s.moments.mean;
      const statistics::Correlation c = statistics::spearman(values, y);
      all_p.push_back(c.p);
      correlations.push_back({{"readout", readout}, {"rho", c.r}, {"n", c.n}});
    }
    factors.push_back({{"name", key},
                       {"label", Names::whole(key)},
                       {"meaning", row.description},
                       {"unit", row.unit == "1" ? "" : row.unit},
                       {"values", values},
                       {"correlations", correlations}});
  }
  const std::vector<double> holm = statistics::holm(all_p);
  std::size_t next = 0;
  for (Json& factor : factors)
    for (Json& c : factor["correlations"]) c["p_holm"] = holm[next++];
  return {{"points", places(study)}, {"factors", factors}};
}

/// What was measured, with its error; "" of no condition.
Json targets_json(const Study& study) {
  Json list = Json::array();
  for (const Target& t : study.targets) {
    std::vector<std::string> at;
    for (const std::size_t c : t.at) at.push_back(study.conditions[c].label);
    list.push_back({{"readout", t.readout},
                    {"low", t.low},
                    {"high", t.high},
                    {"error", t.error},
                    {"at", fmt::format("{}", fmt::join(at, ", "))}});
  }
  return list;
}

/// "Stiffness: 4 points x 12 replicates": studies with one title are told apart.
std::string titled(const Study& study) {
  return fmt::format("{}: {} point{} x {} replicate{}", study.title.empty() ? "Study" : study.title,
                     study.points.size(), study.points.size() == 1 ? "" : "s", study.replicates,
                     study.replicates == 1 ? "" : "s");
}

/// Command, date, versions of the program, runs done: from the files of the folder alone.
Json facts_json(const StudyFolder& study, const std::vector<Result>& results) {
  std::size_t done = 0;
  std::string last;
  for (const Result& r : results) {
    if (!r.standing.done()) continue;
    ++done;
    last = std::max(last, r.standing.end);
  }
  Json facts = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) facts.push_back({{"name", name}, {"value", value}});
  };
  add("command", command_of(study));
  if (last.size() >= 16) add("date", fmt::format("{} {} UTC", last.substr(0, 10), last.substr(11, 5)));
  const std::vector<std::string> programs = programs_of(results);
  if (!programs.empty()) add("program", fmt::format("matrigrate {}", fmt::join(programs, ", ")));
  add("runs done", fmt::format("{} of {}", done, results.size()));
  return facts;
}

/// "Speed, start to end (v_migr_abs)"; the label alone of a read-out without words.
std::string named(const Json& readout) {
  std::string label = readout.at("label");
  std::string meaning = readout.at("meaning");
  if (meaning == label || meaning == readout.at("name")) return label;
  meaning.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(meaning.front())));
  return fmt::format("{} ({})", meaning, label);
}

/// What came out of the first read-out, in a sentence: its extremes, and how many comparisons are significant, if any
/// were wanted.
std::string result_sentence(const Study& study, const Collected& found) {
  if (study.readouts.empty()) return {};
  const Json readout = readouts_json(study).at(0);
  std::vector<ReadOutSample> defined = samples(study, found.results);
  std::erase_if(defined, [&](const ReadOutSample& s) { return readout.at("name") != s.readout || s.moments.n == 0; });
  const std::string label = named(readout);
  if (defined.empty()) return fmt::format("{}: no run has a value yet.", label);
  std::string unit = readout.at("unit");
  if (!unit.empty()) unit = " " + unit;
  const auto value = [&](const ReadOutSample& s) {
    return fmt::format("{:.3g}{} (mean of {} run{}) at {}", s.moments.mean, unit, s.moments.n,
                       s.moments.n == 1 ? "" : "s", point_text(study, s.point));
  };
  const auto [low, high] = std::ranges::minmax_element(defined, {}, [](const auto& s) { return s.moments.mean; });
  if (defined.size() == 1) return fmt::format("{} is {}.", label, value(*low));
  if (std::min(low->moments.n, high->moments.n) < least_runs)
    return fmt::format(
        "{} goes from {:.3g} to {:.3g}{} over {} points; of fewer than {} runs none is called the lowest "
        "or the highest.",
        label, low->moments.mean, high->moments.mean, unit, defined.size(), least_runs);
  std::size_t tested = 0;
  std::size_t significant = 0;
  for (const Comparison& c : found.comparisons) {
    const bool enough = std::min(c.sample_a.n, c.sample_b.n) >= least_runs;
    if (readout.at("name") != c.readout || !enough || std::isnan(c.p_holm)) continue;
    ++tested;
    if (c.p_holm < study.comparisons.alpha) ++significant;
  }
  const std::string extremes = fmt::format("{} is lowest, {}, and highest, {}", label, value(*low), value(*high));
  if (study.comparisons.pairs == Pairs::none) return extremes + ".";
  return extremes + "; "
         + (tested == 0 ? fmt::format("no comparison has {} runs at both points.", least_runs)
                        : fmt::format("{} of {} comparisons {} significant (p < {:.3g} after Holm's correction).",
                                      significant, tested, significant == 1 ? "is" : "are", study.comparisons.alpha));
}

/// A table that only some studies have: one of an earlier form of the study would mislead.
void write_or_remove(const std::filesystem::path& file, bool wanted, const std::string& text) {
  if (wanted)
    write_file(file, text);
  else
    run::remove_file(file);
}

/// The tables of what the runs look like.
void write_curves(const StudyFolder& study, const std::vector<Result>& results) {
  constexpr std::size_t max_points = 60;
  const bool wanted = study.study.points.size() <= max_points;
  const auto write = [&](const char* name, const auto& table) {
    write_or_remove(study.folder / name, wanted, wanted ? table(study.study, results, study.folder) : std::string());
  };
  write("paths.csv", paths_csv);
  write("msd.csv", msd_csv);
  write("adhesions.csv", adhesions_csv);
}

/// The rows of results.csv in the folder of the study; none if there is no such table.
store::CsvTable table_there(const StudyFolder& study) {
  const std::filesystem::path file = study.folder / "results.csv";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  try {
    return store::read_csv(read_file(file, largest_table));
  } catch (const InputOutputError&) { // a damaged table, which is made anew
    return {};
  }
}

constexpr std::size_t most_played = 5;        ///< that are chosen unasked
constexpr std::size_t max_bytes = 12'000'000; ///< of all of them

struct Choice {
  const Result* result;
  std::string why;
};

/// Of the runs of a point that are done, the one in the middle by the first read-out.
std::optional<Choice> typical(const StudyFolder& study, const std::vector<Result>& results, std::size_t point) {
  const std::string& readout = study.study.readouts.front();
  const std::size_t column = readout_column(readout);
  std::vector<const Result*> runs;
  for (const Result& r : results)
    if (r.run.point == point && r.standing.done() && std::isfinite(r.readouts[column])) runs.push_back(&r);
  if (runs.empty()) return {};
  const auto by_value = [&](const Result* r) { return r->readouts[column]; };
  std::ranges::sort(runs, {}, by_value);
  return Choice{runs[(runs.size() - 1) / 2],
                fmt::format("the middle one by {}", readouts_json(study.study).at(0).at("meaning").get<std::string>())};
}

/// Up to most_played points, spread over all of them.
std::vector<Choice> typical_ones(const StudyFolder& study, const std::vector<Result>& results) {
  std::vector<Choice> chosen;
  const std::size_t points = study.study.points.size();
  const std::size_t n = std::min(points, most_played);
  for (std::size_t k = 0; k < n; ++k)
    if (auto choice = typical(study, results, evenly(k, n, points))) chosen.push_back(*choice);
  return chosen;
}

const Result* find(const std::vector<Result>& results, const std::string& id) {
  const auto found = std::ranges::find_if(results, [&](const Result& r) { return r.run.hash == id; });
  return found == results.end() ? nullptr : &*found;
}

/// Every `stride`-th frame, and the last one.
void thin(observe::Film& film, std::size_t stride) {
  std::vector<observe::Frame> kept;
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    if (k % stride == 0 || k + 1 == film.frames.size()) kept.push_back(std::move(film.frames[k]));
  film.frames = std::move(kept);
}

Json page_of(const std::filesystem::path& folder, std::size_t stride) {
  run::FinishedRun run = run::read_run(folder);
  if (stride > 1) thin(run.film, stride);
  return page_data(run);
}

} // namespace

Json study_data(const StudyFolder& folder, const Collected& found, const Json& played,
                const std::vector<tracks::CellTrack>& tracks) {
  const Study& study = folder.study;
  const std::vector<Result>& results = found.results;
  const std::vector<Json> place = places(study);
  const auto done = std::ranges::count_if(results, [](const Result& r) { return r.standing.done(); });
  Json runs = Json::array();
  for (const Result& result : results) runs.push_back(run_json(study, folder.folder, result, place[result.run.point]));
  Json msd = Json::array();
  for (std::size_t i = 0; i < place.size(); ++i) msd.push_back(msd_json(mean_msd(results, i, folder.folder), place[i]));
  std::string status = fmt::format("{} of {} runs done.", done, results.size());
  if (const std::string rim = rim_text(study, results); !rim.empty()) status += " " + rim;
  Json data{{"format", "matrigrate-study"},
            {"version", 1},
            {"title", titled(study)},
            {"status", status},
            {"summary", result_sentence(study, found)},
            {"facts", facts_json(folder, results)},
            {"runs", std::move(runs)},
            {"msd", std::move(msd)},
            {"correlation", correlation_json(study, results)},
            {"scatter", scatter_json(study, results)},
            {"claims", claims_json(found.claims)},
            {"claims_note", claims_note(study)},
            {"targets", targets_json(study)},
            {"players", played},
            {"measured", measured_json(study, tracks, place)},
            {"provenance", run::provenance_text()},
            {"citation", report::citation()}};
  data.update(compared_json(study, results, found.comparisons));
  return data;
}

std::vector<std::string> gone_runs(const StudyFolder& study, const std::vector<Result>& now) {
  const store::CsvTable table = table_there(study);
  const auto run = table.column("run"), label = table.column("label"), replicate = table.column("replicate"),
             seed = table.column("seed"), status = table.column("status");
  if (!run || !label || !replicate || !seed || !status) return {};
  std::map<std::vector<std::string>, std::string> done_there; // names of folders; the other keys outlive these
  for (const auto& row : table.rows)
    if (row[*status] == to_string(RunState::done)) done_there[{row[*label], row[*replicate], row[*seed]}] = row[*run];
  std::vector<std::string> gone;
  for (const Result& r : now) {
    if (r.standing.ended() || r.standing.status == RunState::damaged) continue;
    const auto there = done_there.find(
        {study.study.points[r.run.point].label, fmt::format("{}", r.run.replicate), fmt::format("{}", r.run.seed)});
    if (there != done_there.end())
      gone.push_back(fmt::format("{} (runs/{}): {}", title_of(study, r.run), there->second,
                                 r.standing.reason.empty() ? to_string(r.standing.status) : r.standing.reason));
  }
  return gone;
}

void require_no_loss(const StudyFolder& study, const std::vector<Result>& now) {
  const std::vector<std::string> gone = gone_runs(study, now);
  if (gone.empty()) return;
  throw InputOutputError(
      fmt::format("{}: is kept as it is: it holds results of runs that are not done here any more:\n  {}\n"
                  "Put their folders back into runs/, compute them again with matrigrate study run, or move the table "
                  "elsewhere to make one without them",
                  (study.folder / "results.csv").string(), run::listed(gone, "\n  ")));
}

Collected gathered(const StudyFolder& study) {
  Collected c;
  c.results = results(study.study, study.runs, study.folder);
  c.comparisons = comparisons(study.study, c.results);
  return c;
}

Collected collect_tables(const StudyFolder& study, const std::vector<Result>& kept) {
  Collected c = gathered(study);
  const std::vector<Result> all = with_kept(c.results, kept);
  require_no_loss(study, all);
  write_file(study.folder / "results.csv", results_csv(study.study, all));
  write_file(study.folder / "groups.csv", groups_csv(study.study, c.results));
  write_file(study.folder / "statistics.csv", statistics_csv(study.study, c.comparisons, c.results));
  write_file(study.folder / "correlations.csv", correlations_csv(correlations(study.study, c.results)));
  write_curves(study, c.results);
  return c;
}

void write_study_report(const StudyFolder& study, Collected& collected, const StudyPage& page) {
  collected.claims = claims_about(study, collected.results);
  write_or_remove(study.folder / "claims.csv", !collected.claims.empty(), claims_csv(collected.claims));
  const Json played = played_runs(study, collected.results, page.played, page.tracks);
  write_file(study.folder / "report.html",
             report::filled_page(page.page_template, study_data(study, collected, played, page.tracks)));
}

std::string fault_of_wanted(const std::vector<Result>& results, const std::vector<std::string>& wanted) {
  for (const std::string& id : wanted) {
    const Result* result = find(results, id);
    if (result == nullptr) return fmt::format("there is no run \"{}\" in this study", id);
    if (!result->standing.done()) return fmt::format("run {} is not done", id);
  }
  return {};
}

Json played_runs(const StudyFolder& study, const std::vector<Result>& results, const std::vector<std::string>& wanted,
                 const std::vector<tracks::CellTrack>& tracks) {
  std::vector<Choice> chosen;
  if (wanted.empty()) chosen = typical_ones(study, results);
  for (const std::string& id : wanted) chosen.push_back({find(results, id), "chosen"});
  Json played = Json::array();
  std::size_t stride = 1;
  for (const auto& [result, why] : chosen) {
    try {
      const std::filesystem::path folder = run_folder(study.folder, result->run);
      Json page = page_of(folder, stride);
      if (played.empty()) {
        stride = page.dump().size() * chosen.size() / max_bytes + 1;
        if (stride > 1) page = page_of(folder, stride);
      }
      page["measured"] = measured_json(tracks_at(study.study, tracks, result->run.point));
      played.push_back({{"id", result->run.hash},
                        {"label", fmt::format("{}: {}", title_of(study, result->run), why)},
                        {"run", std::move(page)}});
    } catch (const InputOutputError&) { // its checkpoint or its frames were deleted
      if (!wanted.empty()) throw;
    }
  }
  return played;
}

} // namespace matrigrate::study
