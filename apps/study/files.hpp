#pragma once

#include "study_report/study_files.hpp"

#include <string>
#include <vector>

/// What a study has come to, for its page and for people. Test: tests/apps/study_test.cpp
namespace matrigrate::apps {

using study::collect_tables;
using study::Collected;
using study::gathered;
using study::StudyFolder;

/// Writes report.html, with the paper's claims about the study.
/// @param played  names of the runs it is to play; none: typical ones
/// @throws UsageError if one of them is none of the study, or is not done
void write_study_report(const StudyFolder& study, const Collected& collected,
                        const std::vector<std::string>& played = {});

/// All of its files.
Collected collect(const StudyFolder& study);

/// Means of all points and what differs, for people.
std::string collected_text(const StudyFolder& study, const Collected& collected);

} // namespace matrigrate::apps
