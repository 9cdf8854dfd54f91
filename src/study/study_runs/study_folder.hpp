#pragma once

#include "study_plan/read_study.hpp"
#include "study_plan/study.hpp"
#include "study_results/results.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
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

/// The path of a folder from the root, without a slash at its end.
std::filesystem::path full_path(const std::filesystem::path& folder);

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

// How far the runs of a study are that are being computed, from their files; nothing is written.
// Test: tests/apps/study_test.cpp

/// A run that a process is computing.
struct RunningRun {
  std::size_t run;            ///< index into StudyFolder::runs
  double share;               ///< of the simulated time that is done [0 to 1], by its last row in tracks.csv
  std::optional<double> left; ///< wall time left at its mean pace so far; none before its second row [s]
};

struct StudyProgress {
  std::vector<RunningRun> running;
  std::optional<double>
      left; ///< wall time of all that is not done, at as many runs at a time as now; none if unknown [s]
};

/// @param standings  of all runs, in their order
StudyProgress progress_of(const StudyFolder& study, const std::vector<Standing>& standings);

// What a study takes. Test: tests/unit/study_runs/study_folder_test.cpp

/// Estimated cost of a study, before anything is computed.
struct StudyCost {
  double wall_time = 0.0;        ///< of all runs, one after the other, one thread each [s]
  double memory_bytes = 0.0;     ///< of the largest run
  double disk_bytes = 0.0;       ///< of all runs
  std::vector<double> run_times; ///< of a run at each point [s]
  std::size_t looked_at = 0;     ///< points that warnings were looked for at
  std::vector<std::string> warnings;
};

StudyCost cost(const StudyFolder& study);

} // namespace matrigrate::study
