#pragma once

#include "claims/claims.hpp"
#include "study_results/comparison.hpp"
#include "study_runs/study_folder.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The tables and the page of a study. Test: tests/apps/study_test.cpp, tests/apps/study_report_test.cpp
namespace matrigrate::study {

/// The results of a study so far.
struct Collected {
  std::vector<Result> results;
  std::vector<Comparison> comparisons;
  std::vector<JudgedClaim> claims{}; ///< write_study_report() judges them
};

/// Reads the results of all runs, and compares the points.
Collected gathered(const StudyFolder& study);

/// Reads the results of all runs, writes results.csv, groups.csv, statistics.csv, correlations.csv and, of at
/// most 60 points, paths.csv, msd.csv and adhesions.csv.
/// @param kept  results from elsewhere, which results.csv holds in the place of runs that have not ended in the folder
/// @throws InputOutputError before anything is written, as require_no_loss()
Collected collect_tables(const StudyFolder& study, const std::vector<Result>& kept = {});

/// Runs of the study that results.csv in its folder calls done, and that have not ended now: their folders were moved
/// or removed. A line each.
std::vector<std::string> gone_runs(const StudyFolder& study, const std::vector<Result>& now);

/// @throws InputOutputError if there are gone_runs(): then the tables hold what the runs do not
void require_no_loss(const StudyFolder& study, const std::vector<Result>& now);

/// What the page of a study is made of besides its results.
struct StudyPage {
  std::string_view page_template;          ///< of report/run_page.hpp
  std::vector<std::string> played{};       ///< names of the runs that it plays; none: typical ones
  std::vector<tracks::CellTrack> tracks{}; ///< measured, to be drawn besides those of the targets
};

/// Judges the claims about the study, by it and by the studies beside its folder; writes claims.csv, if there are any,
/// and report.html.
void write_study_report(const StudyFolder& study, Collected& collected, const StudyPage& page);

// The data of the page, as viewer/src/study/contract.ts describes them. Test:
// tests/unit/study_report/study_report_test.cpp

/// @param played  played_runs()
/// @param tracks  measured, to be drawn at all points besides those of the targets
/// @throws InputOutputError if a table of a run that is done cannot be read
nlohmann::ordered_json study_data(const StudyFolder& study, const Collected& collected,
                                  const nlohmann::ordered_json& played = nlohmann::ordered_json::array(),
                                  const std::vector<tracks::CellTrack>& tracks = {});

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

// The files that `matrigrate reproduce` writes of its verdicts. Test: tests/apps/reproduce_test.cpp,
// viewer/tests/verdict_page.test.ts

/// What the page says of how it was made.
struct ClaimReport {
  std::string_view page_template;
  std::string setting; ///< how the runs were made
  std::string command;
};

/// @throws InputOutputError naming the files that write_claim_report() would replace and that are not of this program
void require_own_claim_report(const EvidenceOptions& options);

/// Writes claims-<ID>.csv, claims.csv, report-<ID>.html and the tables of its figures into the folder of the options.
/// @throws InputOutputError if a table cannot be read
void write_claim_report(const std::vector<JudgedClaim>& rows, const Evidence& evidence, const EvidenceOptions& options,
                        const ClaimReport& report);

/// "with runs that ended at the rim made again in a larger disc: holds; ..."
std::string with_larger_disc(const Finding& finding);

} // namespace matrigrate::study
