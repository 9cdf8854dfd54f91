#pragma once

#include "claims/claims.hpp"
#include "study/comparison.hpp"
#include "study/effects.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// The data of a study's report, as viewer/src/study/contract.ts describes them. Test:
/// tests/unit/study_report/study_data_test.cpp
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
  std::vector<JudgedClaim> claims{}; ///< of the paper, about this study
  std::string claims_note{};         ///< what to know of them
  std::string claims_caveat{};       ///< what stands beside each verdict
  std::vector<PlayedRun> played{};
  std::string command{}; ///< that computes the study again
  Screening screening{};
};

/// A verdict in the data of pages: "holds", "fails" or "open".
std::string verdict_word(Verdict verdict);

/// The result of the first read-out, in a sentence: its extremes, and the number of significant comparisons if
/// points are compared.
std::string result_sentence(const StudyReport& report);

/// @throws InputOutputError if a table of a run that is done cannot be read
nlohmann::ordered_json study_data(const StudyReport& report);

} // namespace matrigrate::study
