#pragma once

#include "study_results/discrepancy.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// The part of a study's page on targets, as viewer/src/study/contract.ts describes it.
/// Test: tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// Null for a study without targets.
nlohmann::ordered_json discrepancy_json(const Study& study, const std::vector<Discrepancy>& all);

/// " The discrepancy is least, 1.2 (0.9 to 1.6), at ..."; empty where nothing can be said.
std::string discrepancy_sentence(const Study& study, const std::vector<Discrepancy>& all);

} // namespace matrigrate::study
