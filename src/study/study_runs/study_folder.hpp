#pragma once

#include "study_plan/read_study.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::study {

/// A study and the folder of its runs: study.resolved.toml, scenario.resolved.toml (the base), the measured tracks of
/// its targets, and runs/<hash>/.
struct StudyFolder {
  std::filesystem::path folder;
  Study study;
  std::vector<Run> runs;
};

/// The study with its runs named, and whatever the folder holds of them. A run whose folder another version of the
/// program has called otherwise keeps that name: it is known by its scenario.
/// @param folder  need not exist
StudyFolder planned(Study study, std::filesystem::path folder);

/// "stiffness.toml" -> "stiffness-study"; the folder itself for its own study.resolved.toml.
std::filesystem::path default_study_folder(const std::filesystem::path& file);

/// Requires that the folder is free for the study: it does not exist, is empty but for hidden files and `runs` (of a
/// pool that was killed early), or holds the same study, or one that contains all its points or is contained in it,
/// with any replicates. Points are the same if their runs are: parameters, contents of files of fields, seeds.
/// @throws InputOutputError if not: says what the folder holds, and how that differs. Nothing is written.
void require_own_folder(const StudyFolder& study);

/// Makes the folder, if there is none.
/// @throws InputOutputError as require_own_folder()
void make_study_folder(const StudyFolder& study);

/// Writes study and scenario into the folder, where they differ from what is there. To be done under its lock.
/// @throws InputOutputError as require_own_folder(): others may have written since
void write_study(const StudyFolder& study);

/// The study that a folder holds.
/// @throws InputOutputError if the folder holds none, ConfigurationError if the file was changed to a wrong study
StudyFolder open_study(const std::filesystem::path& folder);

/// The command that computes a run.
/// @param threads  of its process
std::vector<std::string> run_command(const StudyFolder& study, const Run& run, int threads);

/// "youngs_modulus 50 Pa, replicate 3"
std::string title_of(const StudyFolder& study, const Run& run);

} // namespace matrigrate::study
