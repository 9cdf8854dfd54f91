#pragma once

#include "study_results/results.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>

namespace matrigrate::study {

/// The data of a run that do not need its folder: {id, point, seed, status, reason, report: null, readouts, path: null,
/// outline: null, f_adh_rel: []}.
/// @param place  of its point on the axes
nlohmann::ordered_json readouts_of_run(const Study& study, const Result& result, const nlohmann::ordered_json& place);

/// A run as the page of a study takes it (viewer/src/study/contract.ts): how it stands, its read-outs, path and outline
/// at the end.
/// @param place  of its point on the axes
/// @throws InputOutputError if a table of a run that is done cannot be read
/// Test: tests/unit/study_report/study_report_test.cpp, tests/apps/study_test.cpp
nlohmann::ordered_json run_json(const Study& study, const std::filesystem::path& study_folder, const Result& result,
                                const nlohmann::ordered_json& place);

} // namespace matrigrate::study
