#pragma once

#include "study_plan/fault_list.hpp"
#include "study_plan/settings.hpp"
#include "study_plan/study.hpp"
#include "study_plan/sweep.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Conditions of a study, and what its read-outs should be at them. Test: tests/unit/study_plan/targets_test.cpp
namespace matrigrate::study {

/// A condition, and where it stands in the file.
struct ConditionDraft {
  Condition condition;
  Place place;
  std::vector<Named> parameters;
};

/// [[conditions]]: each a `label` and parameters.
std::vector<ConditionDraft> read_conditions(const toml::array& list, const Parameters& base, FaultList& faults);

/// Each factor set under each condition, labelled "condition: set"; the sets as they are without conditions.
std::vector<Draft> crossed(std::vector<Draft> sets, const std::vector<ConditionDraft>& conditions);

/// Faults for parameters that a design varies and a condition sets.
/// @param study  the whole file
void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, const Parameters& base,
                    FaultList& faults);

/// [[targets]]: `readout`, `value` or a range of `low` and `high`, `error`, and, if wanted, `weight` and `at`, the
/// label of a condition or a list of them. `tracks`, a file of measured tracks, stands for value and error: the mean of
/// the read-out over its tracks, and the standard error of this mean.
/// @param folder  that names of files count from
std::vector<Target> read_targets(const toml::array& list, const std::vector<Condition>& conditions,
                                 const std::filesystem::path& folder, FaultList& faults);

/// The [[targets]] of a TOML file, whatever else it holds; at no condition.
/// @throws InputOutputError if a file cannot be read
/// @throws ConfigurationError with all faults; also if there is no target
std::vector<Target> read_target_file(const std::filesystem::path& file);

/// Distance of a value from a target in its standard errors: 0 within a range, from its nearer end outside.
double distance(const Target& target, double value);

/// Distance of a run from all targets, from the distance z of each: sqrt(sum w z^2 / sum w); NaN if a z is.
double distance(const std::vector<Target>& targets, const std::vector<double>& z);

} // namespace matrigrate::study
