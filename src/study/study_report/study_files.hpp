#pragma once

#include "study_report/study_data.hpp"
#include "study_results/comparison.hpp"
#include "study_runs/study_folder.hpp"

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

} // namespace matrigrate::study
