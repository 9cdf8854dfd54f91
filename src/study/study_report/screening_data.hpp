#pragma once

#include "study/effects.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// The part of a study's page on factors and targets, as viewer/src/study/contract.ts describes it.
/// Test: tests/unit/study_report/study_data_test.cpp
namespace matrigrate::study {

/// Null for a study without targets and without a design that gives effects.
nlohmann::ordered_json screening_json(const Study& study, const Screening& screening);

/// " Discrepancy is least, 1.2 (0.9 to 1.6), at ...; the largest effect on ..."; empty where nothing can be said.
std::string screening_sentence(const Study& study, const Screening& screening);

} // namespace matrigrate::study
