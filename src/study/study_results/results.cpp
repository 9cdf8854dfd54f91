#include "study_results/results.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "run/finished_run.hpp"
#include "run/resume.hpp"
#include "run/run_record.hpp"
#include "statistics/distributions.hpp"
#include "statistics/sample.hpp"
#include "store/checkpoint.hpp"
#include "store/run_memory.hpp"
#include "study_plan/names.hpp"
#include "tables/state_json.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace matrigrate::study {

namespace {

using Json = nlohmann::ordered_json;
using statistics::undefined;

constexpr std::size_t largest_json = std::size_t{1} << 24;

/// The last line of a text that says something.
std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::size_t start = text.rfind('\n');
  return start == std::string::npos ? text : text.substr(start + 1);
}

/// The state that run.json tells of.
RunState state_of(const std::optional<run::RunStatus>& status) {
  if (status == run::RunStatus::done) return RunState::done;
  if (status == run::RunStatus::failed) return RunState::failed;
  return status == run::RunStatus::interrupted ? RunState::interrupted : RunState::unfinished;
}

Standing from_log(const std::filesystem::path& log) {
  Standing s;
  if (!std::filesystem::exists(log)) return s;
  s.status = RunState::failed;
  s.reason = last_line(read_file(log, largest_json));
  if (s.reason.empty()) s.status = RunState::unfinished;
  return s;
}

/// A read-out of summary.json; of several cells its mean over those for which it is defined.
double summary_readout(const Json& summary, const char* name) {
  const auto cells = summary.find("cells");
  if (cells == summary.end() || !cells->is_array()) return run::number_in(summary, name).value_or(undefined);
  std::vector<double> values;
  for (const Json& cell : *cells) values.push_back(run::number_in(cell, name).value_or(undefined));
  return statistics::mean_of_defined(values);
}

/// Compares the tables of a run with what its record, or that of version 0.2.0 its checkpoint, says of them.
/// @throws InputOutputError naming the table
void require_whole(const std::filesystem::path& folder) {
  const nlohmann::ordered_json record = run::record_of(folder);
  if (record.is_object() && record.contains("files")) return run::require_unchanged(folder, record);
  const std::filesystem::path file = folder / store::checkpoint_name;
  if (!std::filesystem::exists(file)) return;
  std::string memory;
  try {
    memory = store::read_checkpoint_memory(file);
  } catch (const InputOutputError&) { // the tables are all that is left
    return;
  }
  store::require_whole_tables(memory, folder);
  if (!std::filesystem::exists(folder / "msd.csv")) // which it does not name
    throw InputOutputError(fmt::format("{}: is gone", (folder / "msd.csv").string()));
}

/// Reads the read-outs of a run that is done; notes it as damaged if they cannot be had.
void read(Result& result, const std::filesystem::path& folder) {
  try {
    result.readouts = readouts_of(folder);
  } catch (const InputOutputError& trouble) {
    std::string reason = trouble.what();
    const std::string path = folder.string() + "/"; // results.csv is the same wherever the study lies
    if (reason.starts_with(path)) reason.erase(0, path.size());
    result.standing.status = RunState::damaged;
    result.standing.reason =
        fmt::format("{}; remove runs/{}, and `study run` computes it again", reason, result.run.hash);
  }
}

/// Read-outs of groups, which are last, only where a point has several cells.
std::size_t columns_of(const Study& study) {
  const auto of_groups = std::ranges::count_if(readout_table(), &ReadOutSpec::of_groups);
  return readout_table().size() - (has_several_cells(study) ? 0 : static_cast<std::size_t>(of_groups));
}

} // namespace

std::vector<double> readouts_of(const std::filesystem::path& folder) {
  require_whole(folder);
  const Json summary = store::parse_json(read_file(folder / "summary.json", largest_json));
  if (summary.is_discarded()) throw InputOutputError(fmt::format("{}/summary.json: is no JSON", folder.string()));
  std::vector<double> values;
  const Json& cell = summary.contains("cells") && !summary["cells"].empty() ? summary["cells"].front() : summary;
  const bool whole = cell.contains(readout_table().back().name);
  for (const ReadOutSpec& spec : readout_table()) values.push_back(summary_readout(summary, spec.name.data()));
  if (!whole) run::add_from_tables(folder, values);
  return values;
}

std::string_view to_string(RunState state) { return run_states[static_cast<std::size_t>(state)]; }

std::filesystem::path run_folder(const std::filesystem::path& study_folder, const Run& run) {
  return study_folder / "runs" / run.hash;
}

std::filesystem::path run_log(const std::filesystem::path& study_folder, const Run& run) {
  return study_folder / "runs" / (run.hash + ".log");
}

Standing standing(const std::filesystem::path& study_folder, const Run& run) {
  const std::filesystem::path file = run_folder(study_folder, run) / "run.json";
  Standing s;
  s.status = RunState::unfinished;
  if (!std::filesystem::exists(file)) {
    if (!run::has_checkpoint(file.parent_path())) return from_log(run_log(study_folder, run));
    s.reason = "run.json is missing";
    return s;
  }
  const Json record = store::parse_json(read_file(file, largest_json));
  if (record.is_discarded() || !record.is_object()) {
    s.reason = "run.json is no JSON";
    return s;
  }
  s.status = state_of(run::status_of(record));
  s.reason = run::text_of(record, "reason");
  s.cause = parse_failure_cause(run::text_of(record, "cause"));
  s.trajectory_hash = run::text_of(record, "trajectory_hash");
  s.end = run::text_of(record, "end");
  for (const std::string& program : run::programs_of(record))
    s.programs.push_back(program.substr(program.find(' ') + 1));
  s.wall_time = std::max(0.0, run::number_in(record, "wall_time_s").value_or(0.0));
  if (s.done() && !run::has_summary(file.parent_path())) {
    s.status = RunState::unfinished;
    s.reason = "summary.json is missing or damaged";
  }
  return s;
}

std::vector<Result> results(const Study& study, const std::vector<Run>& runs,
                            const std::filesystem::path& study_folder) {
  std::vector<Result> all;
  all.reserve(study.runs());
  const std::size_t columns = all_readouts().size();
  for (const Run& run : runs) {
    Result result{run, standing(study_folder, run), std::vector<double>(columns, undefined)};
    Standing& now = result.standing;
    if (now.done())
      read(result, run_folder(study_folder, run));
    else if (now.status == RunState::unfinished && !now.reason.empty()) { // its last files are not whole
      now.status = RunState::damaged;
      now.reason += "; `study run` makes it again";
    }
    all.push_back(std::move(result));
  }
  std::ranges::stable_sort(all, {}, [](const Result& r) { return std::pair(r.run.point, r.run.replicate); });
  return all;
}

bool ended_at_rim(const Result& r) { return r.standing.cause == FailureCause::rim; }

std::vector<std::size_t> lost_at_rim(const Study& study, const std::vector<Result>& results) {
  std::vector<std::size_t> lost(study.points.size(), 0);
  for (const Result& r : results)
    if (ended_at_rim(r)) ++lost[r.run.point];
  return lost;
}

std::vector<std::string> programs_of(const std::vector<Result>& results) {
  std::set<std::string> programs;
  for (const Result& r : results)
    if (r.standing.done()) programs.insert(r.standing.programs.begin(), r.standing.programs.end());
  return {programs.begin(), programs.end()};
}

std::string programs_text(const std::vector<Result>& results) {
  const std::vector<std::string> programs = programs_of(results);
  if (programs.size() < 2) return {};
  std::vector<std::string> models; // other than this program's
  for (const std::string& program : programs)
    if (const std::string model = model_text(version_of_program("matrigrate " + program)); !model.empty())
      models.push_back(model);
  const bool all_other = models.size() == programs.size();
  return fmt::format("these runs were made by {} builds of matrigrate: {}. {}: run the study anew into another folder "
                     "(-o).",
                     programs.size(), fmt::join(programs, ", "),
                     models.empty() || all_other
                         ? "If the model changed between them, which the changelog says, they do not belong together"
                         : fmt::format("They do not belong together: {}", fmt::join(models, "; ")));
}

std::string rim_text(const Study& study, const std::vector<Result>& results) {
  constexpr std::size_t most_named = 6;
  const std::vector<std::size_t> lost = lost_at_rim(study, results);
  const std::size_t all = std::accumulate(lost.begin(), lost.end(), std::size_t{0});
  if (all == 0) return {};
  std::vector<std::string> points;
  for (std::size_t i = 0; i < lost.size(); ++i)
    if (lost[i] > 0) points.push_back(fmt::format("{}: {} of {}", study.points[i].label, lost[i], study.replicates));
  if (points.size() > most_named) points = {fmt::format("at {} of {} points", points.size(), study.points.size())};
  double radius = 0.0; // [um]
  for (const Point& point : study.points) radius = std::max(radius, point.parameters.ecm.radius);
  return fmt::format(
      "{} of {} runs ended at the rim of the matrix ({}): means are of the slower cells; take a larger "
      "ecm.radius. With ecm.radius = \"{:.4g} um\" under [set] and another folder (-o) the same seeds run in a "
      "disc {} times as large.",
      all, results.size(), fmt::join(points, "; "), larger_disc * radius, larger_disc);
}

std::vector<Result> replaced(std::vector<Result> results, const std::vector<Result>& by, bool (*lost)(const Result&)) {
  for (const Result& r : by) {
    if (!r.standing.ended()) continue;
    for (Result& old : results)
      if (old.run.point == r.run.point && old.run.replicate == r.run.replicate && lost(old)) old = r;
  }
  return results;
}

std::vector<Result> with_kept(std::vector<Result> results, const std::vector<Result>& kept) {
  return replaced(std::move(results), kept, [](const Result& r) { return !r.standing.ended(); });
}

std::vector<double> sample(const std::vector<Result>& results, std::size_t point, std::string_view readout) {
  const std::size_t column = readout_column(readout);
  std::vector<double> values;
  for (const Result& r : results)
    if (r.run.point == point && std::isfinite(r.readouts[column])) values.push_back(r.readouts[column]);
  return values;
}

std::string unit_suffix(std::string_view unit) {
  if (unit.empty() || unit == "1") return {};
  std::string text(unit.starts_with("1/") ? unit.substr(1) : unit);
  std::string suffix = "_";
  for (const char c : text) {
    if (c == '/')
      suffix += suffix == "_" ? "per_" : "_per_";
    else if (c != '^')
      suffix += c == ' ' ? '_' : c;
  }
  return suffix;
}

std::vector<std::string> swept_columns(const Study& study) {
  std::vector<std::string> names;
  for (const std::string& key : swept_keys(study)) {
    const Row& row = *find_row(key, study.base);
    names.push_back(key + (kind(row) == Kind::quantity ? unit_suffix(row.unit) : ""));
  }
  return names;
}

std::vector<std::string> swept_values(const Study& study, const Point& point) {
  std::vector<std::string> values;
  for (const std::string& key : swept_keys(study))
    values.push_back(swept_text(*find_row(key, point.parameters), point.parameters));
  return values;
}

std::string results_csv(const Study& study, const std::vector<Result>& results) {
  using View = std::string_view;
  std::vector<std::string> columns = all_readouts();
  columns.resize(columns_of(study));
  const auto names = concatenated<std::string>({{"run", "label"},
                                                swept_columns(study),
                                                {"replicate", "seed", "status", "reason", "cause", "trajectory_hash"},
                                                columns});
  std::string text = store::csv_line({names.begin(), names.end()});
  for (const Result& r : results) {
    const Point& point = study.points[r.run.point];
    const Standing& s = r.standing;
    const std::vector<std::string> swept = swept_values(study, point);
    text += store::csv_line(
        concatenated<store::Field>({{View(r.run.hash), View(point.label)},
                                    {swept.begin(), swept.end()},
                                    {std::uint64_t{r.run.replicate}, r.run.seed, to_string(s.status), View(s.reason),
                                     s.cause ? to_string(*s.cause) : View(), View(s.trajectory_hash)},
                                    {r.readouts.begin(), r.readouts.begin() + std::ssize(columns)}}));
  }
  return text;
}

} // namespace matrigrate::study
