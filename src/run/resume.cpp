#include "run/resume.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/changes.hpp"
#include "parameters/document.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "run/folder_lock.hpp"
#include "run/folder_state.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "simulation/step_limits.hpp"
#include "store/checkpoint.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace matrigrate::run {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_scenario = std::size_t{64} << 20U;
constexpr const char* scenario_file = "scenario.resolved.toml";

/// Whether a text gives every parameter of the version that wrote it: a part of a resolved scenario is valid TOML too,
/// with defaults for the rest.
bool is_complete(const std::string& text) {
  const auto document = parse_document(text, scenario_file);
  const auto* table = std::get_if<toml::table>(&document);
  const auto has = [&](const Row& row) {
    return row.before || row.of_part != nullptr || table->at_path(row.path).node() != nullptr;
  };
  return table != nullptr && text.ends_with('\n') && std::ranges::all_of(schema(), has);
}

/// The scenario that a folder's file holds; none if it is missing, incomplete or not valid.
std::optional<Parameters> written_scenario(const fs::path& folder) {
  try {
    const std::string text = read_file(folder / scenario_file, max_scenario);
    if (is_complete(text)) return parse_parameters(text, scenario_file);
  } catch (const InputOutputError&) {   // is not there
  } catch (const ConfigurationError&) { // was damaged
  }
  return std::nullopt;
}

/// What is said where the scenario of a folder is that of its checkpoint.
std::string from_checkpoint(const fs::path& folder) {
  return fmt::format("{}: missing, incomplete or not valid; the parameters are taken from the checkpoint",
                     (folder / scenario_file).string());
}

/// Fingerprint of the scenario of a folder, by its file or else by run.json; empty if neither can be read.
std::string expected_configuration(const fs::path& folder) {
  const std::string written = written_configuration(folder);
  return written.empty() ? text_of(record_of(folder), "configuration_hash") : written;
}

/// A checkpoint that a run can be resumed from.
struct FoundCheckpoint {
  store::Checkpoint checkpoint;
  store::RunMemory memory;
  Parameters p;
  std::filesystem::path file;
};

/// @throws InputOutputError if the file is no whole checkpoint, or not one of the folder's scenario (as far as
///         scenario.resolved.toml or run.json can be read), or if the folder's tables are not those it was written with
FoundCheckpoint read_checkpoint_of(const fs::path& folder, const fs::path& file) {
  FoundCheckpoint found{.checkpoint = store::read_checkpoint(file), .memory = {}, .p = {}, .file = file};
  found.p = parse_parameters(found.checkpoint.scenario, file.string());
  const std::string expected = expected_configuration(folder);
  // Another version of the program may have other parameters, and so other hashes.
  if (!expected.empty() && expected != configuration_hash(found.p) && expected != found.checkpoint.configuration_hash)
    throw InputOutputError(fmt::format("{}: is a checkpoint of another scenario than {}", file.string(),
                                       (folder / scenario_file).string()));
  found.memory = store::parse_memory(found.checkpoint.memory, folder);
  return found;
}

/// The last checkpoint, or the one before.
/// @throws InputOutputError if the run cannot be resumed from this checkpoint, saying whether the previous one can
FoundCheckpoint last_checkpoint(const fs::path& folder, bool previous) {
  const fs::path last = folder / store::checkpoint_name;
  const fs::path before = folder / store::previous_checkpoint_name;
  std::error_code error;
  require(look_at(folder), Use::resume);
  if (previous || (!fs::exists(last, error) && fs::exists(before, error))) return read_checkpoint_of(folder, before);
  try {
    return read_checkpoint_of(folder, last);
  } catch (const InputOutputError& trouble) {
    std::string offer = "there is no other checkpoint";
    try {
      const FoundCheckpoint found = read_checkpoint_of(folder, before);
      offer = fmt::format("the previous checkpoint, at {}, is whole: resume from it with --previous",
                          time_text(found.checkpoint.state.t));
    } catch (const InputOutputError&) { // neither is
    }
    throw InputOutputError(fmt::format("{}; {}", trouble.what(), offer));
  }
}

/// The last whole checkpoint, chosen without asking a user; warns, with the reason, if it is the previous one.
/// @throws InputOutputError if neither checkpoint is whole
FoundCheckpoint whole_checkpoint(const fs::path& folder, RunObserver& observer) {
  try {
    return last_checkpoint(folder, false);
  } catch (const InputOutputError& trouble) {
    std::optional<FoundCheckpoint> before;
    try {
      before = last_checkpoint(folder, true);
    } catch (const InputOutputError&) { // then the trouble with the last one is the one to tell
    }
    if (!before) throw;
    observer.warn(trouble.what());
    return *std::move(before);
  }
}

/// Whether a checkpoint holds the end of a run that ended within a step. A longer run does not pass this state.
bool is_shortened_end(const FoundCheckpoint& found) {
  const double end = found.p.run.duration;
  return found.checkpoint.state.t == end && is_within_step(end, found.p);
}

/// The checkpoint, or in place of a shortened end the one before it, as far as that can be read.
FoundCheckpoint before_shortened_end(FoundCheckpoint found, const fs::path& folder) {
  if (!is_shortened_end(found)) return found;
  try {
    FoundCheckpoint before = read_checkpoint_of(folder, folder / store::previous_checkpoint_name);
    return is_shortened_end(before) ? found : before;
  } catch (const InputOutputError&) { // then the end is what there is
    return found;
  }
}

/// True if a run is done: its record says so, and its checkpoint, if whole, does not contradict, nor is its summary
/// gone.
/// @param record  run.json of the folder
bool is_done(const fs::path& folder, const Json& record, RunObserver& observer) {
  if (status_of(record) != RunStatus::done) return false;
  try {
    const FoundCheckpoint found = read_checkpoint_of(folder, folder / store::checkpoint_name);
    const double t = found.checkpoint.state.t;
    const bool whole = has_summary(folder);
    if (!whole)
      observer.warn(fmt::format("{}: missing or damaged; the end of the run is written again",
                                (folder / "summary.json").string()));
    if (t >= found.p.run.duration - 0.5 * shortest_step(found.p)) return whole;
    observer.warn(fmt::format("{}: says that the run is done, but its checkpoint is at {} of {}",
                              (folder / "run.json").string(), time_text(t), time_text(found.p.run.duration)));
    return false;
  } catch (const InputOutputError& trouble) { // then there is nothing to go on from
    observer.warn(fmt::format("{}; the run is done, but cannot be extended", trouble.what()));
    return true;
  }
}

/// Writes scenario.resolved.toml again, with a warning, if it is missing, incomplete or not valid and there is a whole
/// checkpoint to take it from.
void restore_scenario(const fs::path& folder, RunObserver& observer) {
  if (written_scenario(folder) || !has_checkpoint(folder)) return;
  try {
    write_file(folder / scenario_file, whole_checkpoint(folder, observer).checkpoint.scenario);
    observer.warn(from_checkpoint(folder));
  } catch (const InputOutputError& trouble) { // the results of the run are whole all the same
    observer.warn(trouble.what());
  }
}

/// A start from a checkpoint.
RunStart start_from(const FoundCheckpoint& found, const Json& record) {
  RunStart start{
      .s = found.checkpoint.state, .p = found.p, .memory = found.memory, .before = {}, .lineage = lineage_of(record)};
  start.p.origin.version = text_of(record, "scenario_version");
  if (record.is_object()) {
    start.scenario = scenario_name(record, found.file.parent_path());
    start.commands = commands_of(record);
  }
  start.earlier_wall_time = std::max(0.0, number_in(record, "wall_time_s").value_or(0.0));
  constexpr double most_steps = 1e15;
  start.steps_without_bias =
      static_cast<std::uint64_t>(std::clamp(number_in(record, "steps_without_bias").value_or(0.0), 0.0, most_steps));
  return start;
}

/// An entry of the lineage: "resumed" or "branched".
Json event(std::string_view kind, const FoundCheckpoint& found) {
  return {{"event", kind},
          {"checkpoint", found.file.string()},
          {"step", found.checkpoint.state.step},
          {"t_s", found.checkpoint.state.t},
          {"written_by", found.checkpoint.program},
          {"by", version_line()},
          {"when", time_now()}};
}

/// Warns if another version of the program wrote the checkpoint: that bits may differ, or that its model is another.
void warn_of_other_program(const FoundCheckpoint& found, RunObserver& observer) {
  if (found.checkpoint.program == version_line()) return;
  const std::string model = model_text(version_of_program(found.checkpoint.program));
  observer.warn(fmt::format("{} was written by {}; this is {}. From {} on {}", found.file.string(),
                            found.checkpoint.program, version_line(), time_text(found.checkpoint.state.t),
                            model.empty() ? "the bits may differ" : "another model computes: " + model));
}

/// @throws ConfigurationError if the run in a folder has readings that this program does not compute (Origin::gone)
void require_computable(const Parameters& p, const fs::path& folder) {
  if (std::vector<Fault> faults = faults_of_gone(p, folder.string()); !faults.empty())
    throw ConfigurationError(std::move(faults));
}

RunOutcome done_before(const RunOptions& options, const Json& record, RunObserver& observer) {
  restore_scenario(options.folder, observer);
  return {.folder = options.folder, .computed = false, .record = record, .sentence = {}, .p = {}, .cells = {}};
}

RunOutcome resume_from(FoundCheckpoint last, const RunOptions& options, const Json& record, std::optional<int> threads,
                       RunObserver& observer) {
  const FoundCheckpoint found = before_shortened_end(std::move(last), options.folder);
  require_computable(found.p, options.folder);
  warn_of_other_program(found, observer);
  scenario_of(options.folder, observer); // says so if it cannot be read; it is written again
  RunStart start = start_from(found, record);
  if (threads) start.p.run.threads = *threads;
  start.lineage.push_back(event("resumed", found));
  return run(std::move(start), options, observer);
}

} // namespace

bool has_summary(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / "summary.json";
  return fs::is_regular_file(file, error) && store::parse_json(read_file(file, max_record)).is_object();
}

Parameters scenario_of(const fs::path& folder, RunObserver& observer) {
  if (const std::optional<Parameters> p = written_scenario(folder)) return *p;
  Parameters p = whole_checkpoint(folder, observer).p;
  observer.warn(from_checkpoint(folder));
  return p;
}

std::string written_configuration(const fs::path& folder) {
  const std::optional<Parameters> p = written_scenario(folder);
  return p ? configuration_hash(*p) : std::string();
}

bool has_checkpoint(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / store::checkpoint_name, error)
         || fs::exists(folder / store::previous_checkpoint_name, error);
}

bool has_only_broken_checkpoints(const fs::path& folder) {
  const auto whole = [&](std::string_view name) {
    try {
      read_checkpoint_of(folder, folder / name);
      return true;
    } catch (const std::exception&) { // whatever is wrong with it
      return false;
    }
  };
  return has_checkpoint(folder) && !whole(store::checkpoint_name) && !whole(store::previous_checkpoint_name);
}

RunOutcome resume(const RunOptions& options, const ResumeOptions& from, RunObserver& observer) {
  const Json record = record_of(options.folder);
  if (!from.previous && is_done(options.folder, record, observer)) return done_before(options, record, observer);
  return resume_from(last_checkpoint(options.folder, from.previous), options, record, from.threads, observer);
}

RunOutcome resume(const RunOptions& options, const Parameters& p, RunObserver& observer) {
  const Json record = record_of(options.folder);
  if (is_done(options.folder, record, observer)) return done_before(options, record, observer);
  if (has_checkpoint(options.folder))
    return resume_from(whole_checkpoint(options.folder, observer), options, record, p.run.threads, observer);
  return run({.s = initial_state(p), .p = p}, options, observer);
}

namespace {

/// What a branch goes on from.
struct Origin {
  double t;                              ///< asked for, or that of the last checkpoint [s]
  std::string place;                     ///< what names t: that checkpoint or "--at"
  std::optional<FoundCheckpoint> before; ///< the checkpoint that is closest before t; none: the start
  std::optional<double> after{};         ///< time of the first one after it [s]
  std::set<std::string> programs{};      ///< that wrote any of them
};

/// Finds the checkpoints of a run on the way of a longer one around t. Warns of those that cannot be read.
void look_around(const fs::path& folder, RunObserver& observer, Origin& origin) {
  std::vector<fs::path> files{folder / store::checkpoint_name, folder / store::previous_checkpoint_name};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "checkpoints", error))
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  for (const fs::path& file : files) {
    if (!fs::exists(file, error)) continue;
    try {
      FoundCheckpoint found = read_checkpoint_of(folder, file);
      const double at = found.checkpoint.state.t;
      origin.programs.insert(found.checkpoint.program);
      if (is_shortened_end(found)) continue;
      if (at > origin.t * (1.0 + 1e-12))
        origin.after = std::min(at, origin.after.value_or(at));
      else if (!origin.before || at > origin.before->checkpoint.state.t)
        origin.before = std::move(found);
    } catch (const InputOutputError& trouble) { // an earlier one will do
      observer.warn(fmt::format("{}; it is not used", trouble.what()));
    }
  }
}

/// The start rules but for those on fields: a branch cannot change them, and its checkpoint holds their values, so that
/// their files are not needed.
std::span<const Rule> rules_without_fields() {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> all(start_rules().begin(), start_rules().end());
    std::erase_if(all, [](const Rule& rule) { return kind(*find_row(rule.keys.front())) == Kind::field; });
    return all;
  }();
  return rules;
}

Origin origin_of(const fs::path& folder, const BranchOptions& how, RunObserver& observer) {
  Origin origin{.t = how.at.value_or(0.0), .place = "--at", .before = {}};
  if (!how.at) {
    FoundCheckpoint last = last_checkpoint(folder, how.previous);
    origin.t = last.checkpoint.state.t;
    origin.place = last.file.string();
    if (!is_shortened_end(last)) origin.before = std::move(last);
  }
  if (!origin.before) look_around(folder, observer, origin);
  return origin;
}

bool is_multiple(double t, const Parameters& p) {
  const double steps = t / p.run.time_step;
  return std::abs(steps - std::round(steps)) < 1e-6;
}

/// The first time from t on that is a multiple of the steps of both; none within the next thousand.
std::optional<double> next_multiple(double t, const Parameters& before, const Parameters& after) {
  const double dt = before.run.time_step;
  const double first = std::ceil(t / dt - 1e-6);
  for (int k = 0; k < 1000; ++k)
    if (const double at = dt * (first + k); is_multiple(at, after)) return at;
  return std::nullopt;
}

[[noreturn]] void refuse(const std::string& place, std::string message) {
  throw ConfigurationError({{.file = place, .key = {}, .message = std::move(message)}});
}

/// When the branch begins: at the time that was asked for, or at the next multiple of the step behind the checkpoint.
/// @param after  parameters of the branch
double begin_of(const BranchOptions& how, const Origin& origin, const Parameters& before, const Parameters& after) {
  const double wanted = origin.t;
  const std::optional<double> next = next_multiple(wanted, before, after);
  const std::string steps = before.run.time_step == after.run.time_step
                                ? fmt::format("run.time_step, {:.6g} s", before.run.time_step)
                                : fmt::format("run.time_step, {:.6g} s before and {:.6g} s in the branch",
                                              before.run.time_step, after.run.time_step);
  const bool fits = is_multiple(wanted, before) && is_multiple(wanted, after);
  if (!next || (how.at && !fits))
    refuse("--at", fmt::format("{:.6g} s is no multiple of {}{}", wanted, steps,
                               next ? fmt::format("; --at \"{:.6g} s\" is", *next) : ""));
  const double until = how.at ? wanted : *next;
  if (until < after.run.duration) return until;
  if (how.at)
    refuse("--at", fmt::format("{:.6g} s is not before the end, {:.6g} s; --hours sets another end", until,
                               after.run.duration));
  refuse(
      origin.place,
      fmt::format("the checkpoint is at {:.6g} s, and the branch would end at {:.6g} s: --hours sets a later end, --at "
                  "an earlier time to branch at",
                  wanted, after.run.duration));
}

/// A branch without a checkpoint before it computes the past of its run anew. Warns if another build computed that.
/// @throws ConfigurationError if a program with another model did, or other parameters: the past would be another
void require_own_past(const fs::path& from, const Json& record, const Origin& origin, RunObserver& observer) {
  std::set<std::string> programs = origin.programs;
  for (std::string& program : programs_of(record)) programs.insert(std::move(program));
  programs.erase(version_line());
  const std::string none = fmt::format("{} has no checkpoint at {} or before", from.string(), time_text(origin.t));
  for (const Json& event : lineage_of(record))
    if (const double at = event.value("at_s", 0.0); at > 0.0)
      refuse("--at", fmt::format("{}, and it is a branch, whose past up to {} had other parameters: branch from {}",
                                 none, time_text(at), event.value("from", "the run it came from")));
  for (const std::string& program : programs)
    if (const std::string model = model_text(version_of_program(program)); !model.empty())
      refuse("--at", fmt::format("{}, so that its past would be computed anew; {} computed it, and {}. {}", none,
                                 program, model,
                                 origin.after
                                     ? fmt::format("--at \"{:.6g} s\" or later begins from a checkpoint", *origin.after)
                                     : "No later checkpoint is left: only that version can make the branch"));
  if (!programs.empty())
    observer.warn(fmt::format("{}: its past, computed by {}, is computed anew by {}, and the bits may differ", none,
                              fmt::join(programs, " and "), version_line()));
}

/// A change of the scenario that comes later sets what an option sets for the time until then.
void warn_of_later_changes(const Parameters& before, const Parameters& after, RunObserver& observer) {
  for (const ChangeWords& change : words_of_changes(after)) {
    const std::string path = change.what.substr(0, change.what.find(' '));
    if (const Row* row = find_row(path, after); differs(*row, before, after))
      observer.warn(
          fmt::format("{} = {} holds until {}, when a change of the scenario sets it; --set changes=[] leaves "
                      "such changes out",
                      path, value_text(*row, after), change.when));
  }
}

/// Makes the folder of a branch. A beginning of it, killed before it had a checkpoint, is removed.
/// @throws InputOutputError if the folder holds anything else
void make_folder_for(const fs::path& folder, const Parameters& p, const Json& event) {
  const FolderState state = look_at_branch(folder, p, event);
  require(state, Use::branch);
  make_folder(folder);
  if (!state.has(Holds::begun_branch)) return;
  const FolderLock lock(folder, FolderLock::Kind::alone, std::chrono::milliseconds(500)); // nobody computes it
  remove_run_files(folder);
}

} // namespace

RunOutcome branch(const fs::path& from, const BranchOptions& how, const RunOptions& options, RunObserver& observer) {
  const Parameters before = scenario_of(from, observer);
  require_computable(before, from);
  const Json record = record_of(from);
  const Origin origin = origin_of(from, how, observer);
  const std::optional<FoundCheckpoint>& found = origin.before;
  const auto parameters_from = [&](double t) { // what holds then, with the changes to come
    Parameters p = apply_overrides(in_force(before, t), how.overrides, found ? rules_without_fields() : start_rules());
    if (auto faults = faults_of_change(before, p, "--set"); !faults.empty())
      throw ConfigurationError(std::move(faults));
    return p;
  };
  const double until = begin_of(how, origin, before, parameters_from(origin.t));
  const Parameters after = parameters_from(until);
  warn_of_later_changes(in_force(before, until), after, observer);
  RunStart start;
  if (found) {
    warn_of_other_program(*found, observer);
    start = start_from(*found, record);
    start.lineage.push_back(event("branched", *found));
  } else {
    start = {.s = initial_state(before), .p = before};
    if (origin.t > 0.0) require_own_past(from, record, origin, observer);
    start.lineage = lineage_of(record);
    start.lineage.push_back({{"event", "branched"},
                             {"checkpoint", nullptr},
                             {"written_by", program_of(record)},
                             {"by", version_line()},
                             {"when", time_now()}});
  }
  start.scenario = scenario_name(record, from);
  start.commands = commands_of(record);
  start.commands.push_back(options.command_line);
  start.earlier_wall_time = 0.0;
  start.frames_from = from;
  start.lineage.back()["at_s"] = until;
  start.lineage.back()["from"] = from.string();
  start.lineage.back()["configuration_hash"] = configuration_hash(before);
  start.lineage.back()["set"] = how.overrides;
  start.p = after;
  start.before = BranchPoint{.p = before, .until = until};
  make_folder_for(options.folder, after, start.lineage.back());
  return run(std::move(start), options, observer);
}

} // namespace matrigrate::run
