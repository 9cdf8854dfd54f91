#include "study_results/results.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "observe/readout_table.hpp"
#include "run/folder_state.hpp"
#include "tables/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace matrigrate::study {

namespace {

/// A table of results, and all that is wrong with it.
class Kept {
public:
  Kept(const Study& study, const store::CsvTable& table)
      : m_study(study), m_table(table), m_swept(swept_columns(study)) {
    check_columns();
  }

  std::vector<Result> results() {
    for (m_row = 0; m_row < m_table.rows.size(); ++m_row) m_results.push_back(result());
    if (m_results.size() != m_study.runs())
      m_faults.push_back(fmt::format("holds {} runs; the study has {}", m_results.size(), m_study.runs()));
    raise();
    std::ranges::stable_sort(m_results, {}, [](const Result& r) { return std::pair(r.run.point, r.run.replicate); });
    return std::move(m_results);
  }

private:
  void raise() const {
    if (!m_faults.empty()) throw InputOutputError(run::listed(m_faults, "\n  "));
  }

  /// What else is wrong cannot be told without the columns.
  void check_columns() {
    std::vector<std::string> wanted{"run", "label", "replicate", "seed", "status", "reason", "trajectory_hash"};
    wanted.insert(wanted.end(), m_swept.begin(), m_swept.end());
    std::vector<std::string> known{"cause"}; // version 0.1.0 has none
    for (const ReadOutSpec& spec : readout_table()) (spec.is_late ? known : wanted).emplace_back(spec.name);
    known.insert(known.end(), wanted.begin(), wanted.end());
    for (const std::string& name : wanted)
      if (!m_table.column(name)) m_faults.push_back(fmt::format("has no column {}", name));
    for (std::size_t k = 0; k < m_table.header.size(); ++k) {
      const std::string& name = m_table.header[k];
      const auto place = fmt::format("line 1, column {}", k + 1);
      if (std::ranges::find(known, name) == known.end())
        m_faults.push_back(fmt::format("{}: the results of this study have no column \"{}\"", place, name));
      else if (*m_table.column(name) != k)
        m_faults.push_back(fmt::format("{}: {} is there twice", place, name));
    }
    raise();
  }

  const std::string& field(std::string_view column) const { return m_table.rows[m_row][*m_table.column(column)]; }

  void complain(std::string_view column, std::string_view what) {
    m_faults.push_back(
        fmt::format("line {}, column {} ({}): {}", m_row + 2, *m_table.column(column) + 1, column, what));
  }

  std::uint64_t whole_number(std::string_view column) {
    const std::string& text = field(column);
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end) complain(column, fmt::format("\"{}\" is no whole number", text));
    return value;
  }

  double number(std::string_view column) {
    try {
      return store::csv_number(field(column));
    } catch (const InputOutputError& error) {
      complain(column, error.what());
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// The run has the name of its parameters, but people read the columns.
  void check_parameters(const Point& point) {
    const std::vector<std::string> values = swept_values(m_study, point);
    for (std::size_t k = 0; k < m_swept.size(); ++k)
      if (field(m_swept[k]) != values[k])
        complain(m_swept[k],
                 fmt::format("is \"{}\"; the point \"{}\" has {}", field(m_swept[k]), point.label, values[k]));
  }

  /// @param several  whether a value is a mean over several cells
  void check_readout(const ReadOutSpec& spec, double value, bool done, bool several) {
    if (std::isnan(value)) {
      if (done && field(spec.name).empty() && (spec.is_always || (spec.is_count() && !spec.is_late)))
        complain(spec.name, "is empty; every run that is done has it");
    } else if (value < spec.least || value > spec.most) {
      complain(spec.name, fmt::format("is {:g}; allowed are {:g} to {:g}", value, spec.least, spec.most));
    } else if (spec.is_count() && !several && value != std::floor(value)) {
      complain(spec.name, fmt::format("is {:g}; it is a count", value));
    }
  }

  void check_duration(const RunParameters& run, RunState status) {
    const double t = number("duration_s");
    if (status == RunState::done && std::isfinite(t) && std::abs(t - run.duration) > 1.001 * run.time_step)
      complain("duration_s", fmt::format("is {:g}; runs of the study take {:g} s", t, run.duration));
  }

  Result result() {
    Result r;
    r.run = {.point = 0, .replicate = whole_number("replicate"), .seed = whole_number("seed"), .hash = field("run")};
    const auto status = std::ranges::find(run_states, field("status"));
    if (status != run_states.end())
      r.standing.status = static_cast<RunState>(status - run_states.begin());
    else
      complain("status", fmt::format("\"{}\" is no status of a run", field("status")));
    r.standing.reason = field("reason");
    if (m_table.column("cause")) r.standing.cause = parse_failure_cause(field("cause"));
    r.standing.trajectory_hash = field("trajectory_hash");
    const auto point = std::ranges::find(m_study.points, field("label"), &Point::label);
    if (point == m_study.points.end()) {
      complain("label", fmt::format("\"{}\" is no point of the study", field("label")));
    } else {
      r.run.point = static_cast<std::size_t>(point - m_study.points.begin());
      check_parameters(*point);
      check_duration(point->parameters.run, r.standing.status);
    }
    for (const ReadOutSpec& spec : readout_table()) {
      const bool there = m_table.column(spec.name).has_value();
      r.readouts.push_back(there ? number(spec.name) : std::numeric_limits<double>::quiet_NaN());
      if (there) check_readout(spec, r.readouts.back(), r.standing.done(), has_several_cells(m_study));
    }
    return r;
  }

  const Study& m_study;
  const store::CsvTable& m_table;
  std::vector<std::string> m_swept;
  std::size_t m_row = 0;
  std::vector<Result> m_results;
  std::vector<std::string> m_faults;
};

} // namespace

RowsByRun rows_by_run(std::string_view csv, const std::vector<std::string_view>& columns) {
  const store::CsvTable table = store::read_csv(csv);
  const auto column = [&](std::string_view name) {
    if (const auto found = table.column(name)) return *found;
    throw InputOutputError(fmt::format("has no column {}", name));
  };
  const std::size_t point = column("point");
  const auto replicate = table.column("replicate"), cell = table.column("cell");
  std::vector<std::size_t> wanted;
  for (const std::string_view name : columns) wanted.push_back(column(name));
  if (cell) wanted.push_back(*cell);
  RowsByRun all;
  for (const std::vector<std::string>& fields : table.rows) {
    std::vector<double>& row = all[{fields[point], replicate ? fields[*replicate] : ""}].emplace_back();
    for (const std::size_t one : wanted) row.push_back(store::csv_number(fields[one]));
  }
  return all;
}

std::vector<Result> read_results(const Study& study, std::string_view csv, const std::string& name) {
  return naming(name, [&] { return Kept(study, store::read_csv(csv)).results(); });
}

} // namespace matrigrate::study
