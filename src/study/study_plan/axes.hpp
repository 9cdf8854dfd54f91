#pragma once

#include "study_plan/study.hpp"

#include <nlohmann/json.hpp>

#include <vector>

/// Along what the page of a study draws its points. Test: tests/unit/study_report/study_data_test.cpp
namespace matrigrate::study {

/// The parameters that differ between points, with their values in the order to draw: numbers in the unit of the
/// parameter, rising, or words. Where the points are no grid of these values: all factor sets by their labels, and the
/// conditions if there are any.
nlohmann::ordered_json axes_json(const Study& study);

/// For each point its index along each axis.
std::vector<nlohmann::ordered_json> places(const Study& study);

} // namespace matrigrate::study
