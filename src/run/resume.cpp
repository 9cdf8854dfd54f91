#include "run/resume.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/changes.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "run/folder_lock.hpp"
#include "run/folder_state.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/stopped_run.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <span>
#include <utility>

namespace matrigrate::run {

namespace {

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

namespace fs = std::filesystem;

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
