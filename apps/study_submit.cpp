#include "apps/child.hpp"
#include "apps/folder_lock.hpp"
#include "apps/study_verbs.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/trajectory_hash.hpp"

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

constexpr std::size_t most_tasks = 1000; // Slurm's MaxArraySize is 1001 unless a cluster says otherwise
constexpr std::size_t largest_list = std::size_t{1} << 26;
constexpr double seconds_to_stop = 120.0; ///< before its time limit a task is told to stop

/// A word for a shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// What the batch script does: the task in the background, so that the shell can pass on signals and see exit code 75.
/// Slurm's own end of a job (scancel, preemption) signals the shell too, and is no reason to queue it again.
constexpr std::string_view script_body = R"(
cancelled=0
trap 'cancelled=1' TERM
trap 'kill -TERM "$task" 2>/dev/null' USR1
"$program" study task "$folder" "$SLURM_ARRAY_TASK_ID" --list "$list" &
task=$!
wait "$task"
code=$?
while kill -0 "$task" 2>/dev/null; do # a trap ends the wait before the task has ended
  wait "$task"
  code=$?
done
if [ "$code" -eq 75 ] && [ "$cancelled" -eq 0 ]; then
  echo "task $SLURM_ARRAY_TASK_ID was stopped and is queued again"
  scontrol requeue "$SLURM_JOB_ID"
fi
exit "$code"
)";

std::string script(const StudyFolder& study, const SubmitOptions& options, std::size_t tasks, const std::string& list) {
  const std::filesystem::path folder = std::filesystem::absolute(study.folder);
  std::string text = "#!/bin/bash\n";
  const auto add = [&text](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  add("--job-name=matrigrate");
  add(fmt::format("--array=0-{}{}", tasks - 1, options.throttle > 0 ? fmt::format("%{}", options.throttle) : ""));
  add("--ntasks=1");
  add(fmt::format("--cpus-per-task={}", options.cpus));
  add("--requeue");
  add("--open-mode=append");
  add(fmt::format("--signal=B:USR1@{:.0f}", seconds_to_stop));
  add(fmt::format("--output=\"{}/slurm/%A_%a.out\"", folder.string()));
  if (!options.partition.empty()) add("--partition=" + options.partition);
  if (!options.time.empty()) add("--time=" + options.time);
  text +=
      fmt::format("program={}\nfolder={}\nlist={}\n", quoted(std::filesystem::read_symlink("/proc/self/exe").string()),
                  quoted(folder.string()), quoted(list));
  return text + std::string(script_body);
}

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
std::string submitted(const std::filesystem::path& submit_script, const std::filesystem::path& log) {
  const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (output < 0) throw InputOutputError(fmt::format("{}: cannot be written", log.string()));
  Child sbatch({"sbatch", "--requeue", "--parsable", submit_script.string()}, output);
  ::close(output);
  std::optional<int> code;
  while (!(code = sbatch.ended())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::string said = read_file(log, largest_list);
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (*code == no_such_program)
    throw InputOutputError(fmt::format("sbatch is not there, so this is no machine of a Slurm cluster; the job script "
                                       "stands in {}, for `sbatch --requeue` on one that is. `matrigrate study run` "
                                       "computes the study here",
                                       submit_script.string()));
  if (*code != 0)
    throw InputOutputError(
        fmt::format("sbatch refused the job: {}; the job script is {}", said, submit_script.string()));
  return said;
}

void print_job(const SubmitOptions& options, const StudyFolder& study, const std::string& job, std::size_t runs,
               std::size_t tasks) {
  if (options.study.json) {
    const nlohmann::ordered_json json{
        {"folder", study.folder.string()}, {"job", job}, {"runs", runs}, {"tasks", tasks}};
    return print(json.dump(2) + "\n");
  }
  if (runs == 0) return print("nothing to submit: every run is done\n");
  print(fmt::format("job {}: {} runs in {} tasks; `matrigrate study status {}` tells how far it is\n", job, runs, tasks,
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

int submit_study(const SubmitOptions& options) {
  const StudyFolder study = read_study_file(options.study);
  make_study_folder(study.folder);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  const std::vector<std::size_t> open = open_runs(study, options.study.retry_failed);
  const std::size_t chunk = options.chunk > 0 ? options.chunk : (open.size() + most_tasks - 1) / most_tasks;
  const std::size_t tasks = open.empty() ? 0 : (open.size() + chunk - 1) / chunk;
  std::string job;
  if (tasks > 0) {
    make_output_folder(study.folder / "slurm", true);
    const std::string text = task_list(study, open, chunk);
    const std::string list = fmt::format("slurm/tasks-{}.txt", io::text_hash(text));
    write_file(study.folder / list, text);
    write_file(study.folder / "submit.sh", script(study, options, tasks, list));
    job = submitted(study.folder / "submit.sh", study.folder / "slurm" / "sbatch.log");
  }
  print_job(options, study, job, open.size(), tasks);
  return done;
}

int compute_task(const TaskOptions& options) {
  const FolderLock lock(options.folder, FolderLock::Kind::shared);
  const StudyFolder study = open_study(options.folder);
  std::map<std::string, std::size_t> by_hash;
  for (std::size_t i = 0; i < study.runs.size(); ++i) by_hash.emplace(study.runs[i].hash, i);
  std::vector<std::size_t> mine;
  std::istringstream list(read_file(study.folder / options.list, largest_list));
  std::size_t task = 0;
  for (std::string hash; list >> task >> hash;) {
    const auto found = by_hash.find(hash);
    if (task == options.index && found != by_hash.end()) mine.push_back(found->second);
  }
  const PoolOutcome outcome = compute(study, mine, {.jobs = 1, .threads = slurm_threads(), .quiet = true});
  print(troubles_text(study, outcome.troubles));
  print(
      fmt::format("task {}: {} of {} runs done\n", options.index, outcome.done_before + outcome.done_now, mine.size()));
  return outcome.exit_code();
}

} // namespace matrigrate::apps
