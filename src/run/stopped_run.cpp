#include "run/stopped_run.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/document.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/version.hpp"
#include "run/folder_state.hpp"
#include "run/provenance.hpp"
#include "simulation/march.hpp"
#include "simulation/step_limits.hpp"
#include "tables/state_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <optional>
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

} // namespace

bool has_summary(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / "summary.json";
  return fs::is_regular_file(file, error) && store::parse_json(read_file(file, max_record)).is_object();
}

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

void restore_scenario(const fs::path& folder, RunObserver& observer) {
  if (written_scenario(folder) || !has_checkpoint(folder)) return;
  try {
    write_file(folder / scenario_file, whole_checkpoint(folder, observer).checkpoint.scenario);
    observer.warn(from_checkpoint(folder));
  } catch (const InputOutputError& trouble) { // the results of the run are whole all the same
    observer.warn(trouble.what());
  }
}

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

bool is_shortened_end(const FoundCheckpoint& found) {
  const double end = found.p.run.duration;
  return found.checkpoint.state.t == end && is_within_step(end, found.p);
}

FoundCheckpoint before_shortened_end(FoundCheckpoint found, const fs::path& folder) {
  if (!is_shortened_end(found)) return found;
  try {
    FoundCheckpoint before = read_checkpoint_of(folder, folder / store::previous_checkpoint_name);
    return is_shortened_end(before) ? found : before;
  } catch (const InputOutputError&) { // then the end is what there is
    return found;
  }
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

RunStart start_from(const FoundCheckpoint& found, const Json& record) {
  RunStart start{
      .s = found.checkpoint.state, .p = found.p, .memory = found.memory, .before = {}, .lineage = lineage_of(record)};
  start.p.origin.version = text_of(record, "scenario_version");
  if (record.is_object()) {
    start.scenario = scenario_name(record, found.file.parent_path());
    start.commands = commands_of(record);
  }
  start.earlier_wall_time = std::max(0.0, number_in(record, "wall_time_s").value_or(0.0));
  start.steps_without_bias =
      static_cast<std::uint64_t>(std::max(0.0, number_in(record, "steps_without_bias").value_or(0.0)));
  return start;
}

Json event(std::string_view kind, const FoundCheckpoint& found) {
  return {{"event", kind},
          {"checkpoint", found.file.string()},
          {"step", found.checkpoint.state.step},
          {"t_s", found.checkpoint.state.t},
          {"written_by", found.checkpoint.program},
          {"by", version_line()},
          {"when", time_now()}};
}

void warn_of_other_program(const FoundCheckpoint& found, RunObserver& observer) {
  if (found.checkpoint.program == version_line()) return;
  const std::string model = model_text(version_of_program(found.checkpoint.program));
  observer.warn(fmt::format("{} was written by {}; this is {}. From {} on {}", found.file.string(),
                            found.checkpoint.program, version_line(), time_text(found.checkpoint.state.t),
                            model.empty() ? "the bits may differ" : "another model computes: " + model));
}

void require_computable(const Parameters& p, const fs::path& folder) {
  if (std::vector<Fault> faults = faults_of_gone(p, folder.string()); !faults.empty())
    throw ConfigurationError(std::move(faults));
}

} // namespace matrigrate::run
