#include "apps/study/verbs.hpp"

#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "base/process.hpp"
#include "run/folder_lock.hpp"
#include "store/trajectory_hash.hpp"

#include <CLI/StringTools.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

namespace matrigrate::apps {

namespace {

constexpr int seconds_to_stop = 120;     ///< time before its limit at which a task is stopped [s]
constexpr int shortest_time_limit = 300; ///< a task with less would be stopped when it has hardly begun [s]

constexpr std::string_view time_formats = "minutes, minutes:seconds, hours:minutes:seconds, days-hours, "
                                          "days-hours:minutes or days-hours:minutes:seconds, as in 12:00:00";

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Text for a message: control characters as question marks, of a long one the beginning.
std::string shown(std::string text) {
  std::ranges::replace_if(text, is_control, '?');
  return text.size() <= 80 ? text : text.substr(0, 80) + "...";
}

/// A time limit of Slurm's formats [s]; 0 where there is none (0, UNLIMITED, INFINITE), nothing for anything else.
std::optional<long> seconds(const std::string& time) {
  static const std::regex format(
      R"((?:(\d{1,4})-(\d{1,4})(?::(\d{1,4})(?::(\d{1,4}))?)?)|(?:(\d{1,6}):)?(\d{1,6}):(\d{1,6})|(\d{1,7}))");
  static const std::regex none("unlimited|infinite", std::regex::icase);
  if (time.size() > 30) return std::nullopt; // the library's expressions take stack space for each character
  if (std::regex_match(time, none)) return 0;
  std::smatch part;
  if (!std::regex_match(time, part, format)) return std::nullopt;
  const auto number = [&part](std::size_t i) { return part[i].matched ? std::stol(part[i]) : 0L; };
  if (part[1].matched) return 86400 * number(1) + 3600 * number(2) + 60 * number(3) + number(4);
  return part[8].matched ? 60 * number(8) : 3600 * number(5) + 60 * number(6) + number(7);
}

bool is_memory(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view unit = text.substr(digits);
  return digits > 0 && digits <= 12 && unit.size() <= 1 && std::string_view("KMGTkmgt").find(unit) != unit.npos;
}

bool is_word(std::string_view text, std::string_view signs) {
  return std::ranges::all_of(text, [signs](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || signs.find(c) != signs.npos;
  });
}

/// What the batch script does: the task in the background, so that the shell can pass on signals and see exit code 75.
/// Slurm's own end of a job (scancel, preemption) signals the shell too, and is no reason to queue it again.
constexpr std::string_view script_body = R"(
cancelled=0
trap 'cancelled=1' TERM
trap 'kill -TERM "$task" 2>/dev/null' USR1
"${program[@]}" study task "$folder" "$SLURM_ARRAY_TASK_ID" --list "$list" &
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

/// A text with each of these characters written otherwise.
std::string escaped(const std::string& text, char sign, std::string_view instead) {
  std::string all;
  for (const char c : text) all += c == sign ? std::string(instead) : std::string(1, c);
  return all;
}

/// A word for a shell.
std::string quoted(const std::string& word) {
  if (!word.empty() && is_word(word, "_./:=,@%+-")) return word;
  return fmt::format("'{}'", escaped(word, '\'', "'\\''"));
}

/// Everything in the options that Slurm would misread, and a folder whose name cannot be given to Slurm. Since each
/// value becomes part of a line of the job script, characters that could end the line or its quotes are refused.
std::vector<Fault> slurm_faults(const SlurmOptions& options, const std::filesystem::path& folder) {
  std::vector<Fault> faults;
  const auto add = [&](const std::string& option, const std::string& value, const std::string& message) {
    faults.push_back({option, 0, 0, "", fmt::format("\"{}\" {}", shown(value), message)});
  };
  const auto check_word = [&](const std::string& option, const std::string& value, std::string_view signs) {
    if (!value.empty() && (!is_word(value, signs) || !is_word(value.substr(0, 1), "_")))
      add(option, value,
          fmt::format("is not allowed: a letter, a digit or an underscore, and then letters, digits and {}", signs));
  };
  const auto check_controls = [&](const std::string& option, const std::vector<std::string>& words) {
    for (const std::string& word : words)
      if (std::ranges::any_of(word, is_control)) add(option, word, "holds a control character");
  };
  check_word("--account", options.account, "_.:@+-");
  check_word("--partition", options.partition, "_.:@+-,");
  check_word("--qos", options.qos, "_.:@+-,");
  check_word("--mail-user", options.mail_user, "_.:@+-,%");
  if (!options.memory.empty() && !is_memory(options.memory))
    add("--mem", options.memory, "is no size of memory; allowed is a number with K, M, G or T, as in 500M");
  const std::optional<long> limit = options.time.empty() ? 0L : seconds(options.time);
  if (!limit)
    add("--time", options.time, fmt::format("is no time limit of Slurm, which knows {}", time_formats));
  else if (*limit > 0 && *limit < shortest_time_limit)
    add("--time", options.time,
        fmt::format("is too short: a task is stopped {} s before its time limit; allowed is 5:00 and more",
                    seconds_to_stop));
  const std::string name = std::filesystem::absolute(folder).string();
  if (std::ranges::any_of(name, [](char c) { return is_control(c) || c == '"' || c == '\\'; }))
    add("-o", name,
        "holds a control character, a double quote or a backslash, which the name of Slurm's output file cannot hold; "
        "choose another folder");
  if (!options.more.empty() && !options.more.front().starts_with('-'))
    add("--", options.more.front(), "is no option of sbatch: it does not begin with a hyphen");
  check_controls("--", options.more);
  check_controls("--launcher", options.launcher);
  return faults;
}

/// The command that submits the script, word by word.
std::vector<std::string> sbatch_command(const SlurmOptions& options, const std::filesystem::path& script) {
  std::vector<std::string> command{"sbatch", "--requeue", "--parsable"};
  command.insert(command.end(), options.more.begin(), options.more.end());
  command.push_back(script.string());
  return command;
}

/// The command that submits the script, as text for a shell.
std::string shell_text(const std::vector<std::string>& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

/// The job script: each task calls `matrigrate study task`, and is queued again if it was stopped before its end.
/// @param folder  of the study
/// @param tasks   at least 1
/// @param list    which task computes which run: a file in the folder
std::string job_script(const SlurmOptions& options, const std::filesystem::path& folder, std::size_t tasks,
                       const std::string& list) {
  const std::string path = std::filesystem::absolute(folder).string();
  std::string text = "#!/bin/bash\n";
  const auto add = [&text](const std::string& option) { text += "#SBATCH " + option + "\n"; };
  add("--job-name=matrigrate");
  add(fmt::format("--array=0-{}{}", tasks - 1, options.throttle > 0 ? fmt::format("%{}", options.throttle) : ""));
  add("--ntasks=1");
  add(fmt::format("--cpus-per-task={}", options.cpus));
  add("--requeue");
  add("--open-mode=append");
  add(fmt::format("--signal=B:USR1@{}", seconds_to_stop));
  add(fmt::format("--output=\"{}/slurm/%A_%a.out\"", escaped(path, '%', "%%"))); // % begins a replacement
  for (const auto& [option, value] :
       {std::pair("--account=", options.account), std::pair("--partition=", options.partition),
        std::pair("--qos=", options.qos), std::pair("--time=", options.time), std::pair("--mem=", options.memory),
        std::pair("--mail-user=", options.mail_user)})
    if (!value.empty()) add(option + value);
  if (!options.mail_user.empty()) add("--mail-type=END,FAIL"); // without it Slurm sends nothing
  if (!options.more.empty()) text += "# submitted by: " + shell_text(sbatch_command(options, "submit.sh")) + "\n";
  const std::vector<std::string> program =
      options.launcher.empty() ? std::vector{platform::program_file().string()} : options.launcher;
  text += fmt::format("program=({})\nfolder={}\nlist={}\n", shell_text(program), quoted(path), quoted(list));
  return text + std::string(script_body);
}

constexpr std::size_t max_tasks = 1000; // Slurm's MaxArraySize is 1001 unless a cluster says otherwise
constexpr std::size_t largest_run_list = std::size_t{1} << 26;

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
std::string submitted(const SlurmOptions& options, const std::filesystem::path& script,
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
                                       script.string(), shell_text(command)));
  if (*code != 0)
    throw InputOutputError(fmt::format("sbatch refused the job: {}; the job script is {}", said, script.string()));
  return said;
}

void print_job(const SubmitOptions& options, const StudyFolder& study, const std::string& job, std::size_t runs,
               std::size_t tasks) {
  if (options.study.json)
    return print_json({{"folder", study.folder.string()}, {"job", job}, {"runs", runs}, {"tasks", tasks}});
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
    std::string text; // which run is computed by which task: lines "task hash"
    for (std::size_t k = 0; k < open.size(); ++k) text += fmt::format("{} {}\n", k / chunk, study.runs[open[k]].hash);
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
  std::vector<std::size_t> mine;
  std::istringstream list(read_file(study.folder / options.list, largest_run_list));
  std::size_t task = 0;
  for (std::string hash; list >> task >> hash;) {
    if (task != options.index) continue;
    const auto found = std::ranges::find(study.runs, hash, &study::Run::hash);
    if (found != study.runs.end()) mine.push_back(static_cast<std::size_t>(found - study.runs.begin()));
  }
  const PoolOutcome outcome = compute(study, mine, {.threads = slurm_threads()}, true);
  print(troubles_text(study, outcome.troubles));
  print(
      fmt::format("task {}: {} of {} runs done\n", options.index, outcome.done_before + outcome.done_now, mine.size()));
  return exit_code(outcome);
}

} // namespace matrigrate::apps
