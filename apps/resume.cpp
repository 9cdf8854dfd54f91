#include "apps/resume.hpp"

#include "apps/provenance.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/cell_picture.hpp"
#include "io/checkpoint.hpp"
#include "parameters/read.hpp"
#include "parameters/schema.hpp"
#include "parameters/units.hpp"
#include "simulation/start.hpp"
#include "simulation/step_limits.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t most_text = std::size_t{64} << 20U; // of run.json

struct Options {
  std::string folder;
  std::string output;
  std::string at;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> seed;
  std::optional<double> hours;
  std::optional<int> threads;
  std::string wall_time;
  bool previous = false;
  bool json = false;
  bool quiet = false;
  std::vector<std::string> command_line;

  bool branches() const { return !at.empty() || !overrides.empty() || seed || hours; }
};

/// run.json of a folder; null where there is none, or it cannot be read.
Json record_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "run.json", error)) return {};
  const Json json = Json::parse(read_file(folder / "run.json", most_text), nullptr, false);
  return json.is_object() ? json : Json();
}

/// A text of a record; empty where there is none.
std::string text_of(const Json& record, const char* key) {
  const bool there = record.is_object() && record.contains(key) && record.at(key).is_string();
  return there ? record.at(key).get<std::string>() : std::string();
}

std::vector<Json> lineage_of(const Json& record) {
  if (!record.is_object() || !record.contains("lineage") || !record.at("lineage").is_array()) return {};
  return record.at("lineage").get<std::vector<Json>>();
}

std::string now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

/// A checkpoint that can be gone on with.
struct Found {
  io::Checkpoint checkpoint;
  Parameters p;
  fs::path file;
};

/// @throws InputOutputError if the file is no whole checkpoint, or not one of the folder's scenario
Found read_found(const fs::path& folder, const fs::path& file) {
  Found found{.checkpoint = io::read_checkpoint(file), .p = {}, .file = file};
  found.p = parse_parameters(found.checkpoint.scenario, file.string());
  const fs::path scenario = folder / "scenario.resolved.toml";
  if (configuration_hash(read_parameters(scenario)) != configuration_hash(found.p))
    throw InputOutputError(
        fmt::format("{}: is a checkpoint of another scenario than {}", file.string(), scenario.string()));
  return found;
}

/// The last checkpoint. A missing one stands for a crash between two renames: then it is the one before.
Found last_checkpoint(const fs::path& folder, bool previous) {
  const fs::path last = folder / io::checkpoint_name;
  const fs::path before = folder / io::previous_checkpoint_name;
  std::error_code error;
  if (!fs::exists(folder, error)) throw InputOutputError(fmt::format("{}: there is no such folder", folder.string()));
  if (previous || (!fs::exists(last, error) && fs::exists(before, error))) return read_found(folder, before);
  if (!fs::exists(last, error))
    throw InputOutputError(fmt::format("{}: holds no checkpoint to go on from", folder.string()));
  try {
    return read_found(folder, last);
  } catch (const InputOutputError& trouble) {
    std::string offer = "there is no other one";
    try {
      const Found found = read_found(folder, before);
      offer = fmt::format("the one before, at {}, is whole: go on from it with --previous",
                          io::time_text(found.checkpoint.state.t));
    } catch (const InputOutputError&) { // neither is
    }
    throw InputOutputError(fmt::format("{}; {}", trouble.what(), offer));
  }
}

/// The last checkpoint that is whole: nobody may be there to choose.
Found whole_checkpoint(const fs::path& folder) {
  try {
    return last_checkpoint(folder, false);
  } catch (const InputOutputError& trouble) {
    Found found = last_checkpoint(folder, true);
    print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::warning, Stream::err), trouble.what()));
    return found;
  }
}

Beginning beginning_of(const Found& found, const Json& record) {
  Beginning beginning{.s = found.checkpoint.state,
                      .p = found.p,
                      .memory = io::parse_memory(found.checkpoint.memory),
                      .before = {},
                      .lineage = lineage_of(record)};
  if (record.is_object() && record.contains("wall_time_s") && record.at("wall_time_s").is_number())
    beginning.earlier_wall_time = record.at("wall_time_s");
  return beginning;
}

Json event(std::string_view kind, const Found& found) {
  return {{"event", kind},
          {"checkpoint", found.file.string()},
          {"step", found.checkpoint.state.step},
          {"t_s", found.checkpoint.state.t},
          {"written_by", found.checkpoint.program},
          {"by", version_line()},
          {"when", now()}};
}

void tell_other_program(const Found& found) {
  if (found.checkpoint.program == version_line()) return;
  print_error(fmt::format("{} {} was written by {}, this is {}: the bits may differ from here on\n",
                          coloured("matrigrate:", Colour::warning, Stream::err), found.file.string(),
                          found.checkpoint.program, version_line()));
}

int say_done(const Manner& manner, const Json& record) {
  const std::string report = (manner.folder / "report.html").string();
  if (manner.json) {
    Json all{{"folder", manner.folder.string()}, {"report", report}};
    all["summary"] = Json::parse(read_file(manner.folder / "summary.json", most_text), nullptr, false);
    all.update(record);
    print(all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return done;
  }
  if (!manner.quiet) print(fmt::format("{} is done already; nothing was computed.\n", manner.folder.string()));
  print(fmt::format("open {}\n", report));
  return done;
}

int resume_from(const Found& found, const Manner& manner, const Json& record, std::optional<int> threads) {
  tell_other_program(found);
  Beginning beginning = beginning_of(found, record);
  if (threads) beginning.p.run.threads = *threads;
  beginning.lineage.push_back(event("resumed", found));
  return simulate(std::move(beginning), manner);
}

// ---- Branches

/// Sections and keys that the start was made with: a state that exists cannot be given others.
bool of_the_start(std::string_view path) {
  constexpr std::array<std::string_view, 10> fixed{
      "ecm.radius",      "ecm.particle_spacing", "ecm.smoothing_length", "ecm.lattice",  "ecm.cell_hole",
      "ecm.formulation", "cell.radius",          "cell.particles",       "cell.start_x", "cell.start_y"};
  return std::ranges::find(fixed, path) != fixed.end();
}

/// @throws ConfigurationError naming every parameter that the branch cannot change
void require_same_start(const Parameters& before, const Parameters& after) {
  std::vector<Fault> faults;
  for (const Row& row : schema())
    if (of_the_start(row.path) && value_text(row, before) != value_text(row, after))
      faults.push_back({.file = "--set",
                        .key = std::string(row.path),
                        .message = fmt::format("a branch goes on with the bodies that there are, made with {}; only a "
                                               "new run can have {}",
                                               value_text(row, before), value_text(row, after))});
  if (!faults.empty()) throw ConfigurationError(std::move(faults));
}

/// The checkpoint that lies closest before t; none: the start.
std::optional<Found> checkpoint_before(const fs::path& folder, double t) {
  std::vector<fs::path> files{folder / io::checkpoint_name, folder / io::previous_checkpoint_name};
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "checkpoints", error))
    files.push_back(entry.path());
  std::optional<Found> best;
  for (const fs::path& file : files) {
    try {
      Found found = read_found(folder, file);
      const double at = found.checkpoint.state.t;
      if (at <= t * (1.0 + 1e-12) && (!best || at > best->checkpoint.state.t)) best = std::move(found);
    } catch (const InputOutputError&) { // another one will do
    }
  }
  return best;
}

void require_multiple(double t, const Parameters& p) {
  const double steps = t / p.run.time_step;
  if (std::abs(steps - std::round(steps)) > 1e-6)
    throw ConfigurationError(
        {{.file = "--at",
          .key = {},
          .message = fmt::format("{:.6g} s is no multiple of run.time_step, {:.6g} s", t, p.run.time_step)}});
}

int branch(const Options& options, Manner manner) {
  const fs::path from = options.folder;
  const Parameters before = read_parameters(from / "scenario.resolved.toml");
  std::vector<std::string> overrides = options.overrides;
  if (options.hours) overrides.push_back(fmt::format("run.duration={} h", *options.hours));
  if (options.seed) overrides.push_back(fmt::format("run.seed={}", *options.seed));
  if (options.threads) overrides.push_back(fmt::format("run.threads={}", *options.threads));
  const Parameters after = apply_overrides(before, overrides);
  require_same_start(before, after);
  require_stable_step(after);
  const double at = options.at.empty() ? std::numeric_limits<double>::infinity() : wall_time_of(options.at);
  std::optional<Found> found = checkpoint_before(from, at);
  if (!found && options.at.empty()) throw InputOutputError(from.string() + ": holds no checkpoint to branch from");
  const double until = options.at.empty() ? found->checkpoint.state.t : at;
  require_multiple(until, before);
  require_multiple(until, after);
  if (until >= after.run.duration)
    throw ConfigurationError({{.file = "--at",
                               .key = {},
                               .message = fmt::format("{:.6g} s is not before the end, {:.6g} s; --hours sets another",
                                                      until, after.run.duration)}});

  const Json record = record_of(from);
  Beginning beginning;
  if (found) {
    tell_other_program(*found);
    beginning = beginning_of(*found, record);
    beginning.lineage.push_back(event("branched", *found));
  } else {
    beginning = {.s = initial_state(before), .p = before};
    beginning.lineage = lineage_of(record);
    beginning.lineage.push_back(
        {{"event", "branched"}, {"checkpoint", nullptr}, {"by", version_line()}, {"when", now()}});
  }
  beginning.earlier_wall_time = 0.0;
  beginning.frames_from = from;
  beginning.lineage.back()["at_s"] = until;
  beginning.lineage.back()["from"] = from.string();
  beginning.lineage.back()["configuration_hash"] = configuration_hash(before);
  beginning.lineage.back()["set"] = overrides;
  beginning.p = after;
  beginning.before = Before{.p = before, .until = until};
  make_output_folder(manner.folder, false);
  return simulate(std::move(beginning), manner);
}

int resume(const Options& options) {
  Manner manner{
      .folder = options.folder, .json = options.json, .quiet = options.quiet, .command_line = options.command_line};
  if (!options.wall_time.empty()) manner.wall_time_limit = wall_time_of(options.wall_time);
  if (options.branches()) {
    fs::path name(options.folder);
    if (!name.has_filename()) name = name.parent_path();
    manner.folder = options.output.empty() ? name.string() + "-branch" : options.output;
    return branch(options, std::move(manner));
  }
  if (!options.output.empty())
    throw UsageError("-o is for branches: with --at, --set, --seed or --hours; a run goes on in its own folder");
  const Json record = record_of(options.folder);
  if (!options.previous && text_of(record, "status") == "done") return say_done(manner, record);
  return resume_from(last_checkpoint(options.folder, options.previous), manner, record, options.threads);
}

} // namespace

bool holds_run(const fs::path& folder, const Parameters& p) {
  const Json record = record_of(folder);
  return text_of(record, "configuration_hash") == configuration_hash(p);
}

int go_on(const Manner& manner, const Parameters& p) {
  const Json record = record_of(manner.folder);
  if (text_of(record, "status") == "done") return say_done(manner, record);
  std::error_code error;
  const bool any = std::filesystem::exists(manner.folder / io::checkpoint_name, error)
                   || std::filesystem::exists(manner.folder / io::previous_checkpoint_name, error);
  if (any) return resume_from(whole_checkpoint(manner.folder), manner, record, p.run.threads);
  return simulate({.s = initial_state(p), .p = p}, manner); // it was ended before its first checkpoint
}

void add_resume(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("resume", "Go on with a run from its last checkpoint, or branch off from it");
  verb->footer(
      "Without --at, --set, --seed and --hours the run goes on in its own folder, to the same bits as if it had never\n"
      "stopped. With one of them a branch is begun in a folder of its own: at the last checkpoint, or at the time of\n"
      "--at, which is reached from the closest checkpoint before. Its tables hold the run's history too, and\n"
      "\"lineage\" in its run.json says where it comes from.\n"
      "A checkpoint that is cut short, changed, of another scenario or format is refused; the one before is offered.");
  const auto options = std::make_shared<Options>();
  options->command_line = std::move(command_line);
  verb->add_option("FOLDER", options->folder, "Folder of a run")->required();
  verb->add_option("-o,--output", options->output, "Folder for a branch (default: <FOLDER>-branch)");
  verb->add_option("--at", options->at, "Branch at this simulated time: \"3 h\"");
  verb->add_option("--set", options->overrides, "Branch with key=value; may be repeated")->allow_extra_args(false);
  verb->add_option("--seed", options->seed, "Branch with another seed: run.seed");
  verb->add_option("--hours", options->hours, "Branch with another end: run.duration");
  verb->add_option("--threads", options->threads, "Threads, 0 for all; never changes a result");
  verb->add_option("--wall-time", options->wall_time, "Stop with a checkpoint after this time of the clock: \"2 h\"");
  verb->add_flag("--previous", options->previous, "Go on from checkpoint_prev.h5");
  verb->add_flag("--json", options->json, "Print the outcome as one JSON object");
  verb->add_flag("--quiet", options->quiet, "Show no progress; print only where the report is");
  verb->callback([options, &chosen] { chosen = [options] { return resume(*options); }; });
}

} // namespace matrigrate::apps
