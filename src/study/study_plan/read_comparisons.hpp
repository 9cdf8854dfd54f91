#pragma once

#include "study_plan/fault_list.hpp"
#include "study_plan/study.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate::study {

/// The section [statistics]. Test: tests/unit/study_plan/read_study_test.cpp
/// @param c       the settings where the section has none
/// @param points  whose labels a control may name
Comparisons read_comparisons(const toml::table& table, Comparisons c, const std::vector<Point>& points,
                             FaultList& faults);

/// The labels of the points of another study; none if it is not known.
using LabelsOf = std::function<std::optional<std::vector<std::string>>(const std::string& study)>;

/// The tables [[claims]]. Test: tests/unit/study_plan/read_claims_test.cpp
/// @param points     of the study, whose labels conditions name; those of others are named "study: label"
/// @param labels_of  others; if it is empty, they are not checked
std::vector<Claim> read_claims(const toml::array& list, const std::vector<Point>& points, const LabelsOf& labels_of,
                               FaultList& faults);

} // namespace matrigrate::study
