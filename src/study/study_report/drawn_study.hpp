#pragma once

#include "study_report/run_curves.hpp"
#include "study_results/comparison.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// What pages draw of a study, as viewer/src/study/contract.ts describes it. Test:
/// tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// The read-outs that a study compares: [{name, label, meaning, unit}].
nlohmann::ordered_json readouts_json(const Study& study);

/// Axes, read-outs, samples and comparisons: {axes, readouts, groups, tests}.
nlohmann::ordered_json compared_json(const Study& study, const std::vector<Result>& results,
                                     const std::vector<Comparison>& comparisons);

/// A mean square displacement: {point, lag_min, msd_um2, sem_um2, slope}.
nlohmann::ordered_json msd_json(const std::vector<MeanMsd>& means, const nlohmann::ordered_json& place);

/// Texts of the tables of run_curves.hpp; empty for a missing table.
struct CurveTables {
  std::string paths, shapes, msd, adhesions;
};

/// compared_json with title, runs and msd, from tables alone: {title, axes, readouts, groups, tests, runs, msd}.
/// @throws InputOutputError if a table lacks a column
nlohmann::ordered_json drawn_study(const Study& study, const std::vector<Result>& results, const CurveTables& tables);

} // namespace matrigrate::study
