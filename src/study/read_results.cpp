#include "study/read_results.hpp"

#include "base/failure.hpp"
#include "store/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace matrigrate::study {

namespace {

std::uint64_t whole_number(const std::string& field) {
  std::uint64_t value = 0;
  std::from_chars(field.data(), field.data() + field.size(), value);
  return value;
}

RunState state_of(const std::string& word) {
  for (const RunState state : {RunState::missing, RunState::unfinished, RunState::running, RunState::done,
                               RunState::failed, RunState::interrupted})
    if (word == to_string(state)) return state;
  throw InputOutputError(fmt::format("\"{}\" is no status of a run", word));
}

std::vector<Result> results_of(const Study& study, const store::CsvTable& table) {
  const auto column = [&](std::string_view name) {
    const auto found = table.column(name);
    if (!found) throw InputOutputError(fmt::format("has no column {}", name));
    return *found;
  };
  const std::size_t run = column("run");
  const std::size_t label = column("label");
  const std::size_t replicate = column("replicate");
  const std::size_t seed = column("seed");
  const std::size_t status = column("status");
  const std::size_t reason = column("reason");
  const auto cause = table.column("cause"); // version 0.1.0 has none
  const std::size_t hash = column("trajectory_hash");
  const std::vector<std::string> names = all_readouts();
  std::vector<Result> results;
  for (const std::vector<std::string>& row : table.rows) {
    const auto point = std::ranges::find(study.points, row[label], &Point::label);
    if (point == study.points.end()) throw InputOutputError(fmt::format("\"{}\" is no point of the study", row[label]));
    Result& r = results.emplace_back();
    r.run = {.point = static_cast<std::size_t>(point - study.points.begin()),
             .replicate = whole_number(row[replicate]),
             .seed = whole_number(row[seed]),
             .hash = row[run]};
    r.standing.status = state_of(row[status]);
    r.standing.reason = row[reason];
    if (cause) r.standing.cause = parse_failure_cause(row[*cause]);
    r.standing.trajectory_hash = row[hash];
    for (const std::string& name : names) {
      const auto at = table.column(name);
      r.readouts.push_back(at ? store::csv_number(row[*at]) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  if (results.size() != study.runs())
    throw InputOutputError(fmt::format("holds {} runs; the study has {}", results.size(), study.runs()));
  std::ranges::stable_sort(results, {}, [](const Result& r) { return std::pair(r.run.point, r.run.replicate); });
  return results;
}

} // namespace

std::vector<Result> read_results(const Study& study, std::string_view csv, const std::string& name) {
  try {
    return results_of(study, store::read_csv(csv));
  } catch (const InputOutputError& error) {
    throw InputOutputError(fmt::format("{}: {}", name, error.what()));
  }
}

} // namespace matrigrate::study
