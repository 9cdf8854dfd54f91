#pragma once

#include "study/fault_list.hpp"
#include "study/study.hpp"

#include <vector>

namespace matrigrate::study {

/// The section [statistics]. Test: tests/unit/study/read_study_test.cpp
/// @param c       the settings where the section has none
/// @param points  whose labels a control may name
Comparisons read_comparisons(const toml::table& table, Comparisons c, const std::vector<Point>& points,
                             FaultList& faults);

} // namespace matrigrate::study
