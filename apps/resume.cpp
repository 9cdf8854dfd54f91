#include "run/resume.hpp"
#include "apps/parameter_options.hpp"
#include "apps/run_output.hpp"
#include "apps/shipped_pages.hpp"
#include "apps/verbs.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace matrigrate::apps {

namespace {

struct ResumeArguments {
  std::string folder;
  std::string output;
  ParameterOptions parameters;
  std::string at; ///< time with its unit; empty: the last checkpoint
  bool previous = false;
  std::string wall_time;
  bool json = false;
  bool quiet = false;
  std::vector<std::string> command_line;
};

/// True if the options ask for a branch.
bool branches(const ResumeArguments& options) {
  const ParameterOptions& p = options.parameters;
  return !options.at.empty() || !p.overrides.empty() || p.seed || p.hours;
}

RunOutcome branch_off(const ResumeArguments& options, RunOptions how, RunObserver& observer) {
  std::filesystem::path name(options.folder);
  if (!name.has_filename()) name = name.parent_path();
  how.folder = options.output.empty() ? name.string() + "-branch" : options.output;
  BranchOptions branch{.overrides = all_overrides(options.parameters), .at = {}, .previous = options.previous};
  if (!options.at.empty()) branch.at = seconds_of(options.at);
  try {
    return run::branch(options.folder, branch, how, observer);
  } catch (const ConfigurationError& error) {
    throw naming_options(error, options.parameters);
  }
}

int resume_run(const ResumeArguments& options) {
  RunOptions how{.folder = options.folder, .command_line = options.command_line, .page_template = run_page_template()};
  if (!options.wall_time.empty()) how.wall_time_limit = seconds_of(options.wall_time);
  RunDisplay display(options.quiet || options.json);
  display.may_end_before_first_step(how.wall_time_limit);
  const OutcomeStyle style{.json = options.json, .quiet = options.quiet};
  if (branches(options)) return print_outcome(branch_off(options, how, display), style);
  if (!options.output.empty())
    throw UsageError(
        "-o is only for branches (--at, --set, --seed or --hours); otherwise a run continues in its own folder");
  return print_outcome(resume(how, {.previous = options.previous, .threads = options.parameters.threads}, display),
                       style);
}

} // namespace

void add_resume(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("resume", "Resume a run from its last checkpoint, or branch off from it");
  verb->footer(
      "Without --at, --set, --seed and --hours the run goes on in its own folder, to the same bits as if it had never\n"
      "stopped. With one of them a branch is begun in a folder of its own: at the last checkpoint, or at the time of\n"
      "--at, which is reached from the closest checkpoint before. Its tables hold the run's history too, and\n"
      "\"lineage\" in its run.json says where it comes from.\n"
      "A checkpoint that is cut short, changed, of another scenario or format is refused; the one before is offered.\n"
      "With --at an earlier checkpoint is used instead, with a warning.");
  const auto options = std::make_shared<ResumeArguments>();
  options->command_line = std::move(command_line);
  verb->add_option("FOLDER", options->folder, "Folder of a run")->required();
  verb->add_option("-o,--output", options->output, "Folder for a branch (default: <FOLDER>-branch)");
  verb->add_option("--at", options->at, "Branch at this simulated time: \"3 h\"");
  verb->add_option("--set", options->parameters.overrides, "Branch with key=value; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--seed", options->parameters.seed, "Branch with another seed: run.seed");
  verb->add_option("--hours", options->parameters.hours, "Branch with another end: run.duration");
  add_threads(*verb, options->parameters, "Threads, 0 for as many as pay; never changes a result");
  verb->add_option("--wall-time", options->wall_time, "Stop with a checkpoint after this time of the clock: \"2 h\"");
  verb->add_flag("--previous", options->previous, "Go on, or branch, from checkpoint_prev.h5");
  verb->add_flag("--json", options->json, "Print the outcome as one JSON object");
  verb->add_flag("--quiet", options->quiet, "Show no progress; print only where the report is");
  verb->callback([options, &chosen] { chosen = [options] { return resume_run(*options); }; });
}

} // namespace matrigrate::apps
