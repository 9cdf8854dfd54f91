#pragma once

#include "study_report/study_files.hpp"

#include <string>
#include <vector>

/// The results of a study, for its page and for people. Test: tests/apps/study_test.cpp
namespace matrigrate::apps {

using study::collect_tables;
using study::Collected;
using study::gathered;
using study::StudyFolder;

/// Judges the claims about the study; writes claims.csv and report.html.
/// @param played  names of the runs it is to play; none: typical ones
/// @param tracks  measured, to be drawn besides those of the targets
/// @throws UsageError if one of them is none of the study, or is not done
void write_study_report(const StudyFolder& study, Collected& collected, const std::vector<std::string>& played = {},
                        const std::vector<tracks::CellTrack>& tracks = {});

/// Writes all files of results of the study.
Collected collect(const StudyFolder& study);

/// Means of all points, what differs, and the verdicts on claims, for people.
std::string collected_text(const StudyFolder& study, const Collected& collected);

/// Verdicts in a table, a line per claim, and the bottom lines.
std::string claims_text(const std::vector<study::JudgedClaim>& claims);

} // namespace matrigrate::apps
