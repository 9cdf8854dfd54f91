#include "parameters/changes.hpp"

#include "base/text.hpp"
#include "parameters/assign.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace matrigrate {

namespace {

/// How exactly times agree: less than half of the shortest step [s].
double rounding(const Parameters& p) { return 1e-3 * p.run.time_step; }

const Row& row_of(const TimedChange& change, const Parameters& p) { return *find_row(change.path, p); }

void set(const TimedChange& change, Parameters& p) {
  const toml::table table = toml::parse("value = " + change.value);
  assign(row_of(change, p), given_by(*table.get("value")), p);
}

std::string without_quotes(std::string text) {
  std::erase(text, '"');
  return text;
}

/// `at` as it stands in a scenario file.
std::string time_value(const TimedChange& change) {
  Parameters one;
  one.changes.assign(1, change);
  return value_text(change_time(), one);
}

/// "2 h 20 min", or in one unit where that would be rounded.
std::string shown_time(const TimedChange& change) {
  std::string text = time_text(change.at);
  const units::Quantity read = units::parse_quantity(text);
  if (units::to_internal(read.number, units::parse_unit(read.unit)) == change.at) return text;
  return without_quotes(time_value(change));
}

/// Two values of a parameter, the unit once: "2.8 -> 1.4 N/m".
std::string step_text(const Row& row, const Parameters& before, const Parameters& after) {
  std::string from = value_text(row, before), to = value_text(row, after);
  if (kind(row) != Kind::quantity && kind(row) != Kind::angle) return fmt::format("{} -> {}", from, to);
  from = without_quotes(std::move(from));
  to = without_quotes(std::move(to));
  const std::size_t unit = to.find(' ');
  if (unit != std::string::npos && from.ends_with(to.substr(unit))) from.resize(from.size() - (to.size() - unit));
  return fmt::format("{} -> {}", from, to);
}

/// Why the parameter cannot change while a simulation goes on: the initial state was made with it (geometry and lattice
/// of the matrix, fields, size and particles of cell and nucleus). Fields are kept by the particles, stiffness as a
/// ratio to ecm.youngs_modulus. Empty if it can.
std::string fixed_by_start(const Row& row, const Parameters& before) {
  constexpr std::array fixed{"ecm.radius",    "ecm.particle_spacing", "ecm.smoothing_length", "ecm.lattice",
                             "ecm.cell_hole", "cell.radius",          "cell.particles",       "cell.start_x",
                             "cell.start_y",  "nucleus.radius",       "nucleus.particles"};
  if (kind(row) == Kind::field) return "fields are laid on the matrix at the start";
  if (std::ranges::find(fixed, row.path) != fixed.end()) return "matrix and cells are made with it at the start";
  if ((row.path == "ecm.youngs_modulus" && !before.ecm.fields.youngs_modulus.empty())
      || (row.path == "fibres.stiffness" && !before.fibres.field.stiffness.empty()))
    return "a field takes its place, laid on the matrix at the start";
  return {};
}

} // namespace

std::string fixed_in_run(const Row& row, const Parameters& before) {
  if (section_of(row) == "run" || section_of(row) == "output")
    return fmt::format(
        "cannot change in the middle of a run: [{}] holds for all of it; set it there, or branch the run",
        section_of(row));
  const std::string reason = fixed_by_start(row, before);
  return reason.empty() ? reason : fmt::format("cannot change in the middle of a run: {}", reason);
}

std::vector<Fault> faults_of_change(const Parameters& before, const Parameters& after, const std::string& place) {
  std::vector<Fault> faults;
  for (const Row& row : schema())
    if (!fixed_by_start(row, before).empty() && value_text(row, before) != value_text(row, after))
      faults.push_back({.file = place,
                        .key = std::string(row.path),
                        .message = fmt::format("a branch keeps the bodies of its run, made with {}; only a new run "
                                               "can have {}",
                                               value_text(row, before), value_text(row, after))});
  if (cells_text(before) != cells_text(after))
    faults.push_back({.file = place,
                      .key = "cells",
                      .message = "a branch keeps the cells of its run; only a new run can have others"});
  return faults;
}

Parameters in_force(Parameters p, double t) {
  const auto first = std::ranges::find_if(
      p.changes, [latest = t + rounding(p)](const TimedChange& change) { return change.at > latest; });
  for (auto change = p.changes.begin(); change != first; ++change) set(*change, p);
  p.changes.erase(p.changes.begin(), first);
  return p;
}

std::vector<Period> periods(const Parameters& p) {
  std::vector<Period> all;
  Parameters now = p;
  while (!now.changes.empty()) {
    const double from = now.changes.front().at;
    std::string when = shown_time(now.changes.front());
    now = in_force(std::move(now), from);
    all.push_back({from, std::move(when), now});
  }
  return all;
}

std::vector<ChangeFault> change_faults(const Parameters& p) {
  std::vector<ChangeFault> faults;
  std::set<double> told;
  for (std::size_t k = 0; k < p.changes.size(); ++k) {
    const double at = p.changes[k].at, dt = p.run.time_step;
    if (!told.insert(at).second) continue; // one table has several
    const double below = dt * std::floor(at / dt), above = dt * std::ceil(at / dt);
    if (at >= p.run.duration - rounding(p))
      faults.push_back(
          {k, fmt::format("{} is not before the end of the run, run.duration, {}", shown_time(p.changes[k]),
                          without_quotes(value_text(*find_row("run.duration"), p)))});
    else if (std::abs(at / dt - std::round(at / dt)) > 1e-6)
      faults.push_back({k, fmt::format("{:.6g} s lies within a step: it is no multiple of run.time_step, {:.6g} s; "
                                       "{}{:.6g} s is",
                                       at, dt, below > 0.0 ? fmt::format("{:.6g} s or ", below) : "", above)});
  }
  return faults;
}

std::vector<ChangeWords> words_of_changes(const Parameters& p) {
  std::vector<ChangeWords> words;
  Parameters before = p;
  for (const Period& period : periods(p)) {
    for (const TimedChange& change : p.changes)
      if (change.at == period.from)
        words.push_back({change.at, period.when,
                         fmt::format("{} {}", change.path, step_text(row_of(change, before), before, period.p))});
    before = period.p;
  }
  return words;
}

std::string to_text(const ChangeWords& change) { return fmt::format("at {}: {}", change.when, change.what); }

std::vector<std::vector<std::string>> lines_of_changes(const Parameters& p) {
  std::vector<std::vector<std::string>> tables;
  for (std::size_t k = 0; k < p.changes.size(); ++k) {
    const TimedChange& change = p.changes[k];
    if (k == 0 || p.changes[k - 1].at != change.at) tables.push_back({fmt::format("at = {}", time_value(change))});
    tables.back().push_back(fmt::format("{} = {}", change.path, change.value));
  }
  return tables;
}

std::string changes_text(const Parameters& p) {
  std::vector<std::string> tables;
  for (const std::vector<std::string>& lines : lines_of_changes(p))
    tables.push_back(fmt::format("{{ {} }}", fmt::join(lines, ", ")));
  return fmt::format("[{}]", fmt::join(tables, ", "));
}

} // namespace matrigrate
