#include "run/branch.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "run/folder_lock.hpp"
#include "run/occupied_folder.hpp"
#include "run/own_files.hpp"
#include "run/provenance.hpp"
#include "run/stopped_run.hpp"
#include "simulation/same_start.hpp"
#include "simulation/start.hpp"
#include "simulation/start_rules.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate::run {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The checkpoint that lies closest before t [s] on the way of a longer run; none: the start. Warns of those that
/// cannot be read.
std::optional<FoundCheckpoint> checkpoint_before(const fs::path& folder, double t, RunObserver& observer) {
  std::vector<fs::path> files{folder / store::checkpoint_name, folder / store::previous_checkpoint_name};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "checkpoints", error))
    if (entry.path().extension() == ".h5") files.push_back(entry.path());
  std::optional<FoundCheckpoint> best;
  for (const fs::path& file : files) {
    if (!fs::exists(file, error)) continue;
    try {
      FoundCheckpoint found = read_checkpoint_of(folder, file);
      const double at = found.checkpoint.state.t;
      if (at <= t * (1.0 + 1e-12) && !is_shortened_end(found) && (!best || at > best->checkpoint.state.t))
        best = std::move(found);
    } catch (const InputOutputError& trouble) { // an earlier one will do
      observer.warn(fmt::format("{}; it is not used", trouble.what()));
    }
  }
  return best;
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

/// What a branch goes on from.
struct Origin {
  double t;                             ///< asked for, or that of the last checkpoint [s]
  std::string place;                    ///< what names t: that checkpoint or "--at"
  std::optional<FoundCheckpoint> found; ///< none: the start
};

Origin origin_of(const fs::path& folder, const BranchOptions& how, RunObserver& observer) {
  if (how.at) return {.t = *how.at, .place = "--at", .found = checkpoint_before(folder, *how.at, observer)};
  FoundCheckpoint last = last_checkpoint(folder, how.previous);
  Origin origin{.t = last.checkpoint.state.t, .place = last.file.string(), .found = {}};
  origin.found =
      is_shortened_end(last) ? checkpoint_before(folder, origin.t, observer) : std::optional(std::move(last));
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

/// Whether a folder holds the same branch.
bool holds_the_branch(const fs::path& folder, const Parameters& p, const Json& event) {
  const Json record = record_of(folder);
  const std::vector<Json> lineage = lineage_of(record);
  if (lineage.empty() || text_of(record, "configuration_hash") != configuration_hash(p)) return false;
  const auto agrees = [&](const char* key) { return lineage.back().value(key, Json()) == event.value(key, Json()); };
  return agrees("event") && agrees("from") && agrees("at_s") && agrees("configuration_hash");
}

/// @throws InputOutputError if the folder holds anything else than a beginning of the branch, which was killed before
/// it
///         had a checkpoint and is removed
void require_free_for(const fs::path& folder, const Parameters& p, const Json& event) {
  if (is_free(folder)) return;
  const bool begun = holds_the_branch(folder, p, event);
  if (!begun || has_checkpoint(folder))
    throw InputOutputError(fmt::format("{}: exists and is not empty{}; choose another folder with -o", folder.string(),
                                       begun ? fmt::format(": it holds this branch, which goes on with: matrigrate "
                                                           "resume {}",
                                                           folder.string())
                                             : ""));
  const FolderLock lock(folder, FolderLock::Kind::alone, std::chrono::milliseconds(500)); // nobody computes it
  remove_run_files(folder);
}

} // namespace

RunOutcome branch(const fs::path& from, const BranchOptions& how, const RunOptions& options, RunObserver& observer) {
  const Parameters before = scenario_of(from, observer);
  const Origin origin = origin_of(from, how, observer);
  const std::optional<FoundCheckpoint>& found = origin.found;
  const Parameters after = apply_overrides(before, how.overrides, found ? rules_without_fields() : start_rules());
  if (auto faults = faults_of_change(before, after, "--set"); !faults.empty())
    throw ConfigurationError(std::move(faults));
  const double until = begin_of(how, origin, before, after);

  const Json record = record_of(from);
  RunStart start;
  if (found) {
    warn_of_other_program(*found, observer);
    start = start_from(*found, record);
    start.lineage.push_back(event("branched", *found));
  } else {
    start = {.s = initial_state(before), .p = before};
    start.lineage = lineage_of(record);
    start.lineage.push_back(
        {{"event", "branched"}, {"checkpoint", nullptr}, {"by", version_line()}, {"when", time_now()}});
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
  require_free_for(options.folder, after, start.lineage.back());
  make_output_folder(options.folder, false);
  return run(std::move(start), options, observer);
}

} // namespace matrigrate::run
