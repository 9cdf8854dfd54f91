#pragma once

#include "study/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The tracks of a study in one table. Test: tests/apps/export_study_test.cpp
namespace matrigrate::study {

/// The rows of tracks.csv of all runs that are done, point by point, behind the columns run, label, swept parameters,
/// replicate and seed of results.csv; empty if none is done. What only runs with a nucleus have is empty in the others.
/// @throws InputOutputError if tracks.csv of one of them cannot be read, is damaged, or has columns of its own
std::string tracks_csv(const Study& study, const std::vector<Result>& results,
                       const std::filesystem::path& study_folder);

} // namespace matrigrate::study
