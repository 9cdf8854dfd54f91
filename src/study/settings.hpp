#pragma once

#include "parameters/schema.hpp"
#include "study/fault_list.hpp"
#include "study/study.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Parameters named in a study file. Test: tests/unit/study/read_study_test.cpp
namespace matrigrate::study {

/// A parameter that a table of the file names, and what stands behind it.
struct Named {
  const Row* row;
  const toml::node* node;
};

/// The parameters of a table, in the order of the file; "a.b" = ..., a.b = ... and [table.a] b = ... are the same.
/// Unknown names are faults, and so are run.seed and run.threads, which the study decides on.
/// @param section  how the table is called in faults
/// @param own      keys of the table that are no parameters, and are left to the caller
std::vector<Named> named_parameters(const toml::table& table, std::string_view section,
                                    const std::vector<std::string>& own, FaultList& faults);

/// Gives the parameter a value. @return how it stands in a scenario file; none, and a fault, if it is not allowed
std::optional<Setting> assigned(const Row& row, const toml::node& node, Parameters& p, FaultList& faults);

/// Faults for the rules on several parameters that p breaks.
/// @param places  of parameters in the file; the first one of a rule that is among them is blamed
void check_rules(const Parameters& p, const std::vector<std::pair<std::string, Place>>& places, FaultList& faults);

} // namespace matrigrate::study
