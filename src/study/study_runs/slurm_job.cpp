#include "study_runs/slurm_job.hpp"

#include "base/platform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <string_view>
#include <utility>

namespace matrigrate::study {

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

} // namespace

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

std::vector<std::string> sbatch_command(const SlurmOptions& options, const std::filesystem::path& script) {
  std::vector<std::string> command{"sbatch", "--requeue", "--parsable"};
  command.insert(command.end(), options.more.begin(), options.more.end());
  command.push_back(script.string());
  return command;
}

std::string shell_text(const std::vector<std::string>& command) {
  std::string text;
  for (const std::string& word : command) text += (text.empty() ? "" : " ") + quoted(word);
  return text;
}

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

} // namespace matrigrate::study
