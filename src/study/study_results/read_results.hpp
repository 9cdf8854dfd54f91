#pragma once

#include "study_results/results.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The results of a study from its tables alone, where its runs are no longer there: so that claims can be judged anew
/// by what was kept of them. Test: tests/unit/study_results/read_results_test.cpp
namespace matrigrate::study {

/// All rows, point by point: name, seed, status, fingerprint and read-outs of each run. Read-outs that came after the
/// table are NaN.
/// @param name  stands for the file in messages
/// @throws InputOutputError with the first 20 faults, by line and column, if the text is no results.csv of this study:
///         no table, a column missing, unknown or there twice, a field that is no number, a label, parameter or
///         duration that is none of the study's, or a number of runs other than the study's
std::vector<Result> read_results(const Study& study, std::string_view csv, const std::string& name);

/// Numbers of a table by the label of the point and the replicate, which is "" in tables without.
using RowsByRun = std::map<std::pair<std::string, std::string>, std::vector<std::vector<double>>>;

/// The named columns of a table whose rows belong to runs or points, and, where it has several cells, these behind
/// them.
/// @throws InputOutputError if a column is not there
RowsByRun rows_by_run(std::string_view csv, const std::vector<std::string_view>& columns);

} // namespace matrigrate::study
