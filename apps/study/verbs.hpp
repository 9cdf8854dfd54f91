#pragma once

#include "claims/claims.hpp"
#include "study_report/study_files.hpp"
#include "study_runs/pool.hpp"

#include <string>
#include <vector>

/// The verbs of `matrigrate study`, and what others share with them. Test: tests/apps/study_test.cpp
namespace matrigrate::apps {

using study::collect_tables;
using study::Collected;
using study::gathered;
using study::make_study_folder;
using study::planned;
using study::PoolOutcome;
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

/// What a user asks of Slurm; empty members are left to the cluster.
struct SlurmOptions {
  std::string account;
  std::string partition; ///< one or several, with commas between
  std::string qos;
  std::string time;                  ///< limit of a task, in one of Slurm's formats
  std::string memory;                ///< of a task, as in 500M
  std::string mail_user;             ///< address for a mail when the job ends or fails
  std::size_t throttle = 0;          ///< tasks at a time; 0: no limit
  int cpus = 1;                      ///< per task
  std::vector<std::string> launcher; ///< what a task calls in place of this program, word by word; empty: this program
  std::vector<std::string> more;     ///< further options for sbatch, word by word
};

struct SubmitOptions {
  StudyOptions study;
  SlurmOptions slurm;
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
int print_plan(const StudyFolder& study, int jobs, bool json);

/// Computes the given runs that are not done, as study::compute does; signals to this program stop it, and, unless
/// `quiet`, the standard error shows how far it is.
PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const study::PoolOptions& options,
                    bool quiet);

int exit_code(const PoolOutcome& outcome);

/// Every run that is not done, with its reason: "failed  50 Pa, replicate 3 (0123...): reason".
std::string troubles_text(const StudyFolder& study, const std::vector<study::Trouble>& troubles);

/// Means of all points, what differs, and the verdicts on claims, for people.
std::string collected_text(const StudyFolder& study, const Collected& collected);

/// Verdicts in a table, a line per claim, and the bottom lines.
std::string claims_text(const std::vector<study::JudgedClaim>& claims);

} // namespace matrigrate::apps
