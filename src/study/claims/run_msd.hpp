#pragma once

#include "claims/judge.hpp"

#include <filesystem>
#include <vector>

/// Mean square displacements of runs, from the paths of a study. Test: tests/unit/claims/claims_test.cpp
namespace matrigrate::study {

/// Of each run, in the order of the results; of several cells their mean. Empty of runs without a path.
/// @param tables  files such as paths.csv: a run that stands in several counts as in the first; those that are not
///                there are left out
/// @throws InputOutputError if a table cannot be read
MsdCurves run_msd(const Study& study, const std::vector<Result>& results,
                  const std::vector<std::filesystem::path>& tables);

} // namespace matrigrate::study
