#include "apps/study/verbs.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "run/folder_lock.hpp"
#include "store/trajectory_hash.hpp"
#include "study_runs/slurm_job.hpp"

#include <CLI/StringTools.hpp>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>
#include <thread>

namespace matrigrate::apps {

namespace {

constexpr std::size_t max_tasks = 1000; // Slurm's MaxArraySize is 1001 unless a cluster says otherwise
constexpr std::size_t largest_run_list = std::size_t{1} << 26;

/// Which run is computed by which task: lines "task hash".
std::string task_list(const StudyFolder& study, const std::vector<std::size_t>& open, std::size_t chunk) {
  std::string text;
  for (std::size_t k = 0; k < open.size(); ++k) text += fmt::format("{} {}\n", k / chunk, study.runs[open[k]].hash);
  return text;
}

std::vector<std::size_t> open_runs(const StudyFolder& study, bool retry_failed) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const study::Standing s = study::standing(study.folder, study.runs[i]);
    if (!s.done() && (retry_failed || !s.failed_for_good())) open.push_back(i);
  }
  return open;
}

/// Hands the script to Slurm. @return what sbatch --parsable prints: the number of the job
/// @throws InputOutputError if there is no sbatch, or it refuses
std::string submitted(const study::SlurmOptions& options, const std::filesystem::path& script,
                      const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (output < 0) throw InputOutputError(fmt::format("{}: cannot be written", log.string()));
  const std::vector<std::string> command = sbatch_command(options, std::filesystem::absolute(script));
  Child sbatch(command, output);
  ::close(output);
  std::optional<int> code;
  while (!(code = sbatch.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::string said = read_file(log, largest_run_list);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (*code == no_such_program)
    throw InputOutputError(fmt::format("sbatch was not found, so this machine does not belong to a Slurm cluster; the "
                                       "job script is {}. On a machine with Slurm, submit it by `{}`. To compute the "
                                       "study on this machine: `matrigrate study run`",
                                       script.string(), study::shell_text(command)));
  if (*code != 0)
    throw InputOutputError(fmt::format("sbatch refused the job: {}; the job script is {}", said, script.string()));
  return said;
}

void print_job(const SubmitOptions& options, const StudyFolder& study, const std::string& job, std::size_t runs,
               std::size_t tasks) {
  if (options.study.json)
    return print_as_json({{"folder", study.folder.string()}, {"job", job}, {"runs", runs}, {"tasks", tasks}});
  if (runs == 0) return print("nothing to submit: every run is done\n");
  print(fmt::format("job {}: {} runs in {} tasks; `matrigrate study status {}` shows how far it is\n", job, runs, tasks,
                    study.folder.string()));
}

/// Threads that Slurm gives a task.
int slurm_threads() {
  const char* text = std::getenv("SLURM_CPUS_PER_TASK");
  int threads = 1;
  if (text != nullptr) std::from_chars(text, text + std::string_view(text).size(), threads);
  return std::clamp(threads, 1, 1024);
}

} // namespace

int submit_study(SubmitOptions options) {
  options.slurm.launcher = CLI::detail::split_up(options.launcher);
  const StudyFolder study = read_study_file(options.study);
  std::vector<Fault> faults = slurm_faults(options.slurm, study.folder);
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
  make_study_folder(study);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  const std::vector<std::size_t> open = open_runs(study, options.study.retry_failed);
  const std::size_t chunk = options.chunk > 0 ? options.chunk : (open.size() + max_tasks - 1) / max_tasks;
  const std::size_t tasks = open.empty() ? 0 : (open.size() + chunk - 1) / chunk;
  std::string job;
  if (tasks > 0) {
    make_folder(study.folder / "slurm");
    const std::string text = task_list(study, open, chunk);
    const std::string list = fmt::format("slurm/tasks-{}.txt", store::text_hash(text));
    write_file(study.folder / list, text);
    write_file(study.folder / "submit.sh", job_script(options.slurm, study.folder, tasks, list));
    job = submitted(options.slurm, study.folder / "submit.sh", study.folder / "slurm" / "sbatch.log");
  }
  print_job(options, study, job, open.size(), tasks);
  return done;
}

int compute_task(const TaskOptions& options) {
  const FolderLock lock(options.folder, FolderLock::Kind::shared);
  const StudyFolder study = study::open_study(options.folder);
  std::map<std::string, std::size_t> by_hash;
  for (std::size_t i = 0; i < study.runs.size(); ++i) by_hash.emplace(study.runs[i].hash, i);
  std::vector<std::size_t> mine;
  std::istringstream list(read_file(study.folder / options.list, largest_run_list));
  std::size_t task = 0;
  for (std::string hash; list >> task >> hash;) {
    const auto found = by_hash.find(hash);
    if (task == options.index && found != by_hash.end()) mine.push_back(found->second);
  }
  const PoolOutcome outcome = compute(study, mine, {.threads = slurm_threads()}, true);
  print(troubles_text(study, outcome.troubles));
  print(
      fmt::format("task {}: {} of {} runs done\n", options.index, outcome.done_before + outcome.done_now, mine.size()));
  return exit_code(outcome);
}

} // namespace matrigrate::apps
