#pragma once

#include "apps/study_folder.hpp"
#include "study/comparison.hpp"
#include "study/effects.hpp"

#include <string>
#include <vector>

namespace matrigrate::apps {

/// What a study has come to so far.
struct Collected {
  std::vector<study::Result> results;
  std::vector<study::Comparison> comparisons;
  study::Screening screening;
};

/// Reads the results of all runs, and compares the points.
Collected gathered(const StudyFolder& study);

/// Reads the results of all runs, writes results.csv, groups.csv, statistics.csv, correlations.csv, boxes.svg, and
/// paths, msd and adhesions as .csv and .svg, of at most 60 points; with targets discrepancy.csv, and of designs that
/// screen factors effects.csv.
Collected collect_tables(const StudyFolder& study);

/// Writes report.html.
/// @param played  names of the runs it is to play; none: typical ones
void write_study_report(const StudyFolder& study, const Collected& collected,
                        const std::vector<std::string>& played = {});

/// All of these files.
Collected collect(const StudyFolder& study);

/// Means of all points and what differs, for people.
std::string collected_text(const StudyFolder& study, const Collected& collected);

} // namespace matrigrate::apps
