#pragma once

#include "base/failure.hpp"
#include "parameters/schema.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// Parameters in time, [[changes]] of a scenario: what may change, and what holds when.
/// Test: tests/unit/parameters/changes_test.cpp, tests/physics/simulation_test.cpp
namespace matrigrate {

/// Why the parameter cannot change by [[changes]]: the initial state was made with it, or it holds for a whole run.
/// Empty if it can.
std::string fixed_in_run(const Row& row, const Parameters& before);

/// One fault for each parameter that differs, but the initial state was made with it, and for other cells.
/// @param place  where the new values were given: "--set"
std::vector<Fault> faults_of_change(const Parameters& before, const Parameters& after, const std::string& place);

/// The parameters of a step that begins at t [s]: the scenario with the values of its changes up to then. Only changes
/// to come are left in it.
Parameters in_force(Parameters p, double t);

/// The parameters from a time of change on.
struct Period {
  double from;      ///< [s]
  std::string when; ///< "3 h"
  Parameters p;
};

/// One for each time of change.
std::vector<Period> periods(const Parameters& p);

/// What is wrong with the time of a change.
struct ChangeFault {
  std::size_t change = 0; ///< index into Parameters::changes
  std::string message;
};

/// Changes that come at or after the end, or within a step.
std::vector<ChangeFault> change_faults(const Parameters& p);

/// The rule that tells the first of change_faults().
inline constexpr const char* change_rule = "changes fit the run";

/// A change in words.
struct ChangeWords {
  double at;        ///< [s]
  std::string when; ///< "3 h"
  std::string what; ///< "cell.spring_stiffness 2.8 -> 1.4 N/m"
};

std::vector<ChangeWords> words_of_changes(const Parameters& p);

/// "at 3 h: cell.spring_stiffness 2.8 -> 1.4 N/m".
std::string to_text(const ChangeWords& change);

/// Each table of [[changes]] by its lines: `at = "3 h"`, `cell.spring_stiffness = "1.4 N/m"`.
std::vector<std::vector<std::string>> lines_of_changes(const Parameters& p);

/// The same as one line, [{ at = "3 h", cell.spring_stiffness = "1.4 N/m" }], as after --set changes=; "[]" without.
std::string changes_text(const Parameters& p);

} // namespace matrigrate
