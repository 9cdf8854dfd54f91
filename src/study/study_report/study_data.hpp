#pragma once

#include "claims/claims.hpp"
#include "study_results/comparison.hpp"
#include "study_results/results.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// The data of a study's report, as viewer/src/study/contract.ts describes them. Test:
/// tests/unit/study_report/study_report_test.cpp
namespace matrigrate::study {

/// A run that the page plays.
struct PlayedRun {
  std::string id;              ///< name of its folder
  std::string label;           ///< which one it is, and why it was chosen
  nlohmann::ordered_json page; ///< report::run_data
};

/// What a report is made of.
struct StudyReport {
  const Study& study;
  const std::vector<Result>& results;
  const std::vector<Comparison>& comparisons;
  std::filesystem::path folder;      ///< of the study, whose runs' tables are read
  std::string provenance;            ///< its line breaks are kept
  std::vector<JudgedClaim> claims{}; ///< about this study: its own, and the paper's
  std::string claims_note{};         ///< what to know of them
  std::vector<PlayedRun> played{};
  std::string command{};                   ///< that computes the study again
  std::vector<tracks::CellTrack> tracks{}; ///< measured, to be drawn at all points besides those of the targets
};

/// What came out of the first read-out, in a sentence: its extremes, and how many comparisons are significant, if any
/// were wanted.
std::string result_sentence(const StudyReport& report);

/// @throws InputOutputError if a table of a run that is done cannot be read
nlohmann::ordered_json study_data(const StudyReport& report);

} // namespace matrigrate::study
