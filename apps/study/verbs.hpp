#pragma once

#include "apps/study/pool_output.hpp"
#include "base/process.hpp"
#include "claims/shipped_studies.hpp"
#include "study_runs/slurm_job.hpp"
#include "study_runs/study_folder.hpp"

#include <optional>
#include <string>
#include <vector>

namespace matrigrate::apps {

// The verbs of `matrigrate study`, and what `matrigrate reproduce` shares with them.

using study::make_study_folder;
using study::planned;
using study::PoolOutcome;
using study::shipped_studies;
using study::ShippedStudy;
using study::StudyFolder;

struct StudyOptions {
  std::string file;   ///< of the study
  std::string folder; ///< of its runs
  int jobs = 0;       ///< runs at a time; 0: as many as the machine has cores
  bool retry_failed = false;
  bool json = false;
  bool quiet = false;
};

/// The number of runs at a time that an option asks for.
int job_count(int wanted);

/// Reads the study of a file and names its runs; nothing is written.
StudyFolder read_study_file(const StudyOptions& options);

int run_study(const StudyOptions& options);
int show_status(const StudyOptions& options);
int collect_study(const StudyOptions& options);

struct SubmitOptions {
  StudyOptions study;
  study::SlurmOptions slurm;
  std::string launcher;  ///< what a task calls in place of this program, as typed
  std::size_t chunk = 0; ///< runs per task; 0: as few as fit into 1000 tasks
};
/// Writes the job script and hands it to sbatch.
/// @throws ConfigurationError if the study or an option for Slurm is wrong; nothing is written then
/// @throws InputOutputError if there is no sbatch, or it refuses; the script is kept then
int submit_study(SubmitOptions options);

struct TaskOptions {
  std::string folder;
  std::size_t index = 0;
  std::string list; ///< file in the folder: a line "task hash" for each run
};
int compute_task(const TaskOptions& options);

/// Points, runs and cost, in words or as JSON.
int print_plan(const study::StudyFolder& study, int jobs, bool json);

} // namespace matrigrate::apps
