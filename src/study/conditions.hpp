#pragma once

#include "study/design/sweep.hpp"
#include "study/fault_list.hpp"
#include "study/settings.hpp"
#include "study/study.hpp"

#include <string>
#include <vector>

/// Conditions of a study, and what its read-outs should be at them. Test: tests/unit/study/targets_test.cpp
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

/// Faults for parameters that a design varies and a condition sets, and for those that stand in two designs of which
/// one gives effects.
/// @param study  the whole file
void check_overlaps(const toml::table& study, const std::vector<ConditionDraft>& conditions, FaultList& faults);

/// [[targets]]: `readout`, `value` or a range of `low` and `high`, `error`, and, if wanted, `weight` and `at`, the
/// label of a condition or a list of them.
std::vector<Target> read_targets(const toml::array& list, const std::vector<Condition>& conditions, FaultList& faults);

} // namespace matrigrate::study
