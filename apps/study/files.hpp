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

/// Writes report.html, with the paper's claims about the study.
/// @param played  names of the runs that the page plays; none: typical runs
/// @throws UsageError if a name is not a run of the study, or its run is not done
void write_study_report(const StudyFolder& study, const Collected& collected,
                        const std::vector<std::string>& played = {});

/// Writes all files of results of the study.
Collected collect(const StudyFolder& study);

/// Means of all points, and their differences, for people.
std::string collected_text(const StudyFolder& study, const Collected& collected);

} // namespace matrigrate::apps
