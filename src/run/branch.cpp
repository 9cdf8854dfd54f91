#include "run/branch.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "run/occupied_folder.hpp"
#include "run/provenance.hpp"
#include "run/stopped_run.hpp"
#include "simulation/same_start.hpp"
#include "simulation/start.hpp"
#include "simulation/start_rules.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate::run {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The checkpoint that lies closest before t; none: the start. Warns of those that cannot be read.
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
      if (at <= t * (1.0 + 1e-12) && (!best || at > best->checkpoint.state.t)) best = std::move(found);
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

void require_multiple(double t, const Parameters& p) {
  const double steps = t / p.run.time_step;
  if (std::abs(steps - std::round(steps)) > 1e-6)
    throw ConfigurationError(
        {{.file = "--at",
          .key = {},
          .message = fmt::format("{:.6g} s is no multiple of run.time_step, {:.6g} s", t, p.run.time_step)}});
}

} // namespace

RunOutcome branch(const fs::path& from, const BranchOptions& how, const RunOptions& options, RunObserver& observer) {
  const Parameters before = scenario_of(from, observer);
  std::optional<FoundCheckpoint> found =
      how.at ? checkpoint_before(from, *how.at, observer) : last_checkpoint(from, how.previous);
  const Parameters after = apply_overrides(before, how.overrides, found ? rules_without_fields() : start_rules());
  if (auto faults = faults_of_change(before, after, "--set"); !faults.empty())
    throw ConfigurationError(std::move(faults));
  const double until = how.at ? *how.at : found->checkpoint.state.t;
  require_multiple(until, before);
  require_multiple(until, after);
  if (until >= after.run.duration)
    throw ConfigurationError(
        {{.file = "--at",
          .key = {},
          .message = fmt::format("{:.6g} s is not before the end, {:.6g} s; --hours sets another end", until,
                                 after.run.duration)}});

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
  if (!is_free(options.folder))
    throw InputOutputError(options.folder.string() + ": exists and is not empty; choose another folder with -o");
  make_output_folder(options.folder, false);
  return run(std::move(start), options, observer);
}

} // namespace matrigrate::run
