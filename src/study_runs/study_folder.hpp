#pragma once

#include "study/plan.hpp"
#include "study/read_study.hpp"
#include "study/results.hpp"
#include "study/study.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace matrigrate::study {

/// A study and the folder of its runs: study.resolved.toml, scenario.resolved.toml (the base) and runs/<hash>/.
struct StudyFolder {
  std::filesystem::path folder;
  Study study;
  std::vector<Run> runs;
};

/// The study with its runs named, without a folder on disk.
StudyFolder planned(Study study, std::filesystem::path folder);

/// "stiffness.toml" -> "stiffness-study"; the folder itself for its own study.resolved.toml.
std::filesystem::path default_study_folder(const std::filesystem::path& file);

/// Makes the folder, if there is none. One that holds something else than a study is refused.
/// @throws InputOutputError
void make_study_folder(const std::filesystem::path& folder);

/// Writes study and scenario into the folder, where they differ from what is there. To be done under its lock.
void write_study(const StudyFolder& study);

/// The study that a folder holds.
/// @throws InputOutputError if it holds none, ConfigurationError if that was changed to something wrong
StudyFolder open_study(const std::filesystem::path& folder);

/// The command that computes a run.
/// @param threads  of its process
std::vector<std::string> run_command(const StudyFolder& study, const Run& run, int threads);

/// "youngs_modulus 50 Pa, replicate 3"
std::string title_of(const StudyFolder& study, const Run& run);

} // namespace matrigrate::study
