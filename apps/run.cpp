#include "apps/parameter_options.hpp"
#include "apps/run_output.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "parameters/read.hpp"
#include "run/estimate.hpp"
#include "run/folder_state.hpp"
#include "run/resume.hpp"
#include "simulation/start.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <utility>

namespace matrigrate::apps {

namespace {

struct RunArguments {
  std::string file;
  std::string folder;
  ParameterOptions parameters;
  std::string wall_time;
  bool force = false;
  bool json = false;
  bool quiet = false;
  bool file_is_temporary = false;
  std::vector<std::string> command_line;
};

/// "cell-seed1-youngs_modulus-50Pa": the scenario, its seed, and what --set changes.
std::string default_folder(const RunArguments& options, const Parameters& p) {
  constexpr std::size_t max_length = 120;
  std::string name = fmt::format("{}-seed{}", std::filesystem::path(options.file).stem().string(), p.run.seed);
  for (const std::string& change : options.parameters.overrides) name += tag_of(change);
  return name.substr(0, max_length); // a folder that another run has is refused
}

/// For run.json: the command that makes the run again. A file that is gone by then, as one of Python's, is no part of
/// it.
std::vector<std::string> command_of(const RunArguments& options, const std::string& folder) {
  if (!options.file_is_temporary) return options.command_line;
  const std::string scenario = (std::filesystem::path(folder) / "scenario.resolved.toml").string();
  return {options.command_line.front(), "run", scenario, "-o", folder + "-again"};
}

Parameters parameters_of(const RunArguments& options) {
  try {
    return read_parameters(options.file, all_overrides(options.parameters), start_rules());
  } catch (const ConfigurationError& error) {
    throw naming_options(error, options.parameters);
  }
}

RunOutcome outcome_of(const RunArguments& options, const Parameters& p, const RunOptions& how, RunDisplay& display) {
  const FolderState state = options.force ? look_at(how.folder) : look_at(how.folder, p, display);
  require(state, options.force ? Use::run_anew : Use::run);
  if (state.has(Holds::this_run)) return resume(how, p, display);
  if (options.force) warn_of_other_files(how.folder, display);
  if (const std::string note = note_of_scenario(p); !note.empty()) display.warn(note);
  RunStart start{.s = initial_state(p), .p = p};
  if (options.file_is_temporary) start.scenario = std::filesystem::path(options.file).stem().string();
  make_folder(how.folder);
  if (!options.quiet && !options.json)
    if (const std::string cost = run::cost_of_reference_steps(p); !cost.empty())
      print(fmt::format("{}: {}\n", options.file, cost));
  return run::run(std::move(start), how, display);
}

int run_scenario(const RunArguments& options) {
  const Parameters p = parameters_of(options);
  const std::string folder = options.folder.empty() ? default_folder(options, p) : options.folder;
  RunOptions how{.folder = folder, .command_line = command_of(options, folder), .page_template = run_page_template()};
  if (!options.wall_time.empty()) how.wall_time_limit = seconds_of(options.wall_time);
  RunDisplay display(options.quiet || options.json);
  display.may_end_before_first_step(how.wall_time_limit);
  return print_outcome(outcome_of(options, p, how, display), {.json = options.json, .quiet = options.quiet});
}

} // namespace

void add_run(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb =
      app.add_subcommand("run", "Simulate a cell, or several; write tracks, protrusions, read-outs and a page");
  verb->footer(
      "Writes scenario.resolved.toml, run.json, tracks.csv, protrusions.csv, health.csv, msd.csv, summary.csv, "
      "group.csv\n"
      "(of several cells), summary.json, report.html, the frames in fields.h5 and fields.xdmf (fields.part while it\n"
      "runs), and the exact state in checkpoint.h5, checkpoint_prev.h5 and checkpoints/. Rows are written as they\n"
      "come. Running scenario.resolved.toml again gives the same bits, and so the same trajectory_hash in run.json.\n"
      "A folder that holds the same scenario and seed is resumed from its checkpoint, to the same bits as without the\n"
      "break; one that is done is left as it is. A folder that holds another run is refused, naming the parameters\n"
      "that differ.\n"
      "--json prints {folder, report, summary: {read-outs}, and all keys of run.json}.\n"
      "Ctrl-C ends the run after its current step with a checkpoint and the exit code 130; SIGTERM, SIGUSR1, SIGHUP\n"
      "and --wall-time do so with the code 75, which asks to be started again. A second signal, more than a second\n"
      "later, ends it at once. Under nohup SIGHUP is ignored.");
  const auto options = std::make_shared<RunArguments>();
  options->command_line = std::move(command_line);
  verb->add_option("FILE", options->file, "A scenario file")->required();
  verb->add_option("-o,--output", options->folder,
                   "Folder for the results (default: <scenario>-seed<N>, and what --set changes)");
  verb->add_option("--seed", options->parameters.seed, "Seed of the random numbers: run.seed");
  verb->add_option("--hours", options->parameters.hours, "Simulated time in hours, or as \"30 min\": run.duration");
  add_threads(*verb, options->parameters, "Threads, 0 for as many as pay: run.threads; never changes a result");
  verb->add_option("--set", options->parameters.overrides, "key=value, over the file; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--wall-time", options->wall_time, "Stop with a checkpoint after this time of the clock: \"2 h\"");
  verb->add_flag("--force", options->force,
                 "Start again in a folder that is not empty: files of an older run are removed, others are kept");
  verb->add_flag("--json", options->json, "Print the outcome as one JSON object");
  verb->add_flag("--quiet", options->quiet, "Show no progress; print only where the report is");
  verb->add_flag("--temporary-file", options->file_is_temporary, "FILE will be removed")->group(""); // of Python
  verb->callback([options, &chosen] { chosen = [options] { return run_scenario(*options); }; });
}

} // namespace matrigrate::apps
