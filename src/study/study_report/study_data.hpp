#pragma once

#include "claims/claims.hpp"
#include "study_results/comparison.hpp"
#include "study_results/results.hpp"
#include "study_runs/study_folder.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// The data of a study's report, as viewer/src/study/contract.ts describes them. Test:
/// tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// What a report is made of.
struct StudyReport {
  const Study& study;
  const std::vector<Result>& results;
  const std::vector<Comparison>& comparisons;
  std::filesystem::path folder;                                    ///< of the study, whose runs' tables are read
  std::string provenance;                                          ///< its line breaks are kept
  std::vector<JudgedClaim> claims{};                               ///< about this study: its own, and the paper's
  std::string claims_note{};                                       ///< what to know of them
  nlohmann::ordered_json played = nlohmann::ordered_json::array(); ///< played_runs()
  std::string command{};                                           ///< that computes the study again
  std::vector<tracks::CellTrack> tracks{}; ///< measured, to be drawn at all points besides those of the targets
};

/// @throws InputOutputError if a table of a run that is done cannot be read
nlohmann::ordered_json study_data(const StudyReport& report);

/// Why a wanted run cannot be played: it is not of this study, or is not done; empty if all wanted runs can.
/// @param wanted  names of the folders of runs
std::string fault_of_wanted(const std::vector<Result>& results, const std::vector<std::string>& wanted);

/// The runs that a study's page plays, [{id, label, run: page_data()}], with so few frames that the page stays below
/// 15 MB. The label says which one it is, and why it was chosen. Test: tests/apps/study_test.cpp
/// @param wanted  names of their folders, without fault_of_wanted(); none: of up to five points the run in the middle
/// by the first read-out
/// @param tracks  measured, to be drawn besides those of the targets
/// @throws InputOutputError if a wanted run cannot be read; other unreadable runs are left out
nlohmann::ordered_json played_runs(const StudyFolder& study, const std::vector<Result>& results,
                                   const std::vector<std::string>& wanted,
                                   const std::vector<tracks::CellTrack>& tracks = {});

} // namespace matrigrate::study
