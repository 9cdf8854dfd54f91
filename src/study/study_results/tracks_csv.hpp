#pragma once

#include "exchange/run_tracks.hpp"
#include "study_results/results.hpp"

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

/// The tracks of all runs that are done, in the order of results: times, cells, centres of mass and areas alone.
/// @throws InputOutputError as tracks_csv
std::vector<exchange::RunTracks> run_tracks(const Study& study, const std::vector<Result>& results,
                                            const std::filesystem::path& study_folder);

} // namespace matrigrate::study
