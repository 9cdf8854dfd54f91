#pragma once

#include "base/failure.hpp"
#include "parameters/parameters.hpp"
#include "report/run_page.hpp"
#include "run/status.hpp"
#include "store/field_file.hpp"
#include "store/saved_frames.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The record of a run, run.json. Test: tests/unit/run/run_test.cpp, tests/apps/run_test.cpp
namespace matrigrate::run {

using Json = nlohmann::ordered_json;

inline constexpr std::size_t max_record = std::size_t{64} << 20U; ///< bytes of run.json that are read

/// How a run stands or ended: what run.json holds.
struct RunRecord {
  std::optional<RunEnd> ended;       ///< none while it runs
  std::string reason;                ///< why it ended early; empty if it did not
  std::optional<FailureCause> cause; ///< of a numerical failure
  std::uint64_t steps = 0;
  double t = 0.0;                       ///< simulated time reached [s]
  double march_wall_time = 0.0;         ///< spent in the steps, those before a restart too [s]
  double earlier_wall_time = 0.0;       ///< of this run before it was resumed [s]
  std::uint64_t steps_without_bias = 0; ///< in which the bias of a cell was 0 along its whole cortex
  store::LostFrames lost_frames;
  std::string trajectory_hash;
  std::string configuration_hash;
  std::map<std::string, std::string> files;       ///< fingerprints of those that others read results from, at the end
  std::vector<std::string> command_line;          ///< of the process that wrote it
  std::string scenario;                           ///< name of the scenario that the run was started from
  std::vector<std::vector<std::string>> commands; ///< that started the run and then each branch, oldest first
  std::vector<Json> lineage;                      ///< restarts and branches, oldest first
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();
  std::optional<std::chrono::system_clock::time_point> end;
  std::chrono::steady_clock::time_point steady_start = std::chrono::steady_clock::now(); ///< nobody sets it back
  std::optional<std::chrono::steady_clock::time_point> steady_end;

  /// Notes that the run ends now.
  void note_end();
  double wall_time() const; ///< of this run, also before it was resumed [s]

  RunStatus status() const { return ended ? status_of(*ended) : RunStatus::running; }
};

/// run.json of a folder; null where there is none, or it cannot be read.
Json record_of(const std::filesystem::path& folder);

/// The record in the text of a run.json.
/// @throws InputOutputError if it is no JSON object, or has a value of another type
Json parse_record(std::string_view text);

/// run.json of a folder, to be shown.
/// @throws InputOutputError naming the file, if it cannot be read, is no JSON object, or has a value of another type
Json read_record(const std::filesystem::path& folder);

/// A text of a record; empty where there is none.
std::string text_of(const Json& record, const char* key);

/// A number of a record; nothing where there is none.
std::optional<double> number_in(const Json& record, const char* key);

/// The program that wrote a record, "matrigrate 0.3.0 (1234abcd)"; empty if it does not tell.
std::string program_of(const Json& record);

/// All programs that computed the run of a record, as program_of() names them, oldest first.
std::vector<std::string> programs_of(const Json& record);

/// How the run of a record stands; nothing if the record does not tell.
std::optional<RunStatus> status_of(const Json& record);

/// The restarts and branches that a record tells of, oldest first.
std::vector<Json> lineage_of(const Json& record);

/// Words as one would type them in a shell, the program by its name alone.
std::string command_text(const std::vector<std::string>& words);

/// The time of day in records: "2026-01-31T12:00:00Z".
std::string time_now();

/// "2026-01-31 12:00 UTC"
std::string minute_text(std::chrono::system_clock::time_point time);

/// run.threads in texts that name or describe a run, since it decides on no result: that of all versions so far.
inline constexpr int threads_in_texts = 1;

/// Fingerprint of all that decides on the results: the resolved scenario but for the number of threads.
std::string configuration_hash(const Parameters& p);

/// Fingerprints of tracks.csv, protrusions.csv, group.csv, msd.csv and summary.json in a folder, as far as they are
/// there.
std::map<std::string, std::string> result_fingerprints(const std::filesystem::path& folder);

/// Compares these files with the fingerprints in a record. One of version 0.2.0 has none.
/// @throws InputOutputError naming the first file that is missing or has been changed
void require_unchanged(const std::filesystem::path& folder, const Json& record);

/// The name of the scenario: "cell". Without one in the record: that of the scenario file in the command; of a run of a
/// study the name of the run's folder; or, without a file, the name of the run's folder less its seed.
/// @param record  as in run.json
std::string scenario_name(const Json& record, const std::filesystem::path& folder);

/// The commands that started a run and then each branch, oldest first; none if the record names none.
/// @param record  as in run.json
std::vector<std::vector<std::string>> commands_of(const Json& record);

/// What fields.h5 says of the run. The number of threads is left out: it changes no result, and may differ after a
/// resume.
/// @param trajectory_hash  empty for a run that is not finished
store::FieldOrigin field_origin(Parameters p, std::string trajectory_hash);

/// Heading of the run's report: "cell: E = 200 Pa, seed 1".
std::string run_title(const Parameters& p, const std::string& scenario);

/// "the bias of initiation was 0 along the whole cortex in 120 of 240 steps; ...": what a record tells of them; empty
/// of none.
/// @param record  as in run.json
std::string bias_sentence(const Json& record);

/// The texts of the laws that are not the default ones, by their keys, and of the constants that they may name.
Json laws_json(const Parameters& p);

/// [{at_s, what: "cell.spring_stiffness 2.8 -> 1.4 N/m"}]: the changes of parameters in time.
Json changes_json(const Parameters& p);

/// What was run, when and how: scenario, stiffness, seed, closures, changed laws, the commands that started it and its
/// branches, date, wall time, trajectory hash.
/// @param record  as in run.json
std::vector<report::Fact> run_facts(const Parameters& p, const Json& record, const std::string& scenario);

/// {status, exit_code, reason, cause: to_string(FailureCause) or null, seed, steps, t_s, duration_s, wall_time_s,
/// ms_per_step, trajectory_hash,
///  configuration_hash, closures: Closures::text, scenario_version: of the program that wrote the scenario, if its
///  model is another, else null, laws: laws_json(), changes: changes_json(), steps_without_bias, files: {name:
///  fingerprint}, frames_lost, frames_lost_s: [first, last] or null, command_line, scenario, commands, start, end,
///  lineage, and the keys of provenance()}
Json to_json(const RunRecord& record, const Parameters& p);

} // namespace matrigrate::run
