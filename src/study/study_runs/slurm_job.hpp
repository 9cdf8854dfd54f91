#pragma once

#include "base/failure.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// The job array that `matrigrate study submit` hands to Slurm. Test: tests/apps/submit_test.cpp
namespace matrigrate::study {

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

/// Everything in the options that Slurm would misread, and a folder whose name cannot be given to Slurm. Since each
/// value becomes part of a line of the job script, characters that could end the line or its quotes are refused.
std::vector<Fault> slurm_faults(const SlurmOptions& options, const std::filesystem::path& folder);

/// The command that submits the script, word by word.
std::vector<std::string> sbatch_command(const SlurmOptions& options, const std::filesystem::path& script);

/// The command that submits the script, as text for a shell.
std::string shell_text(const std::vector<std::string>& command);

/// The job script: each task calls `matrigrate study task`, and is queued again if it was stopped before its end.
/// @param folder  of the study
/// @param tasks   at least 1
/// @param list    which task computes which run: a file in the folder
std::string job_script(const SlurmOptions& options, const std::filesystem::path& folder, std::size_t tasks,
                       const std::string& list);

} // namespace matrigrate::study
