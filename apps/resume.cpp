#include "apps/resume.hpp"

#include "apps/branch.hpp"
#include "apps/stopped_run.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/file.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::size_t most_text = std::size_t{1} << 20U; // of summary.json

struct Options {
  std::string folder;
  std::string output;
  BranchOptions branch;
  std::string wall_time;
  bool json = false;
  bool quiet = false;
  std::vector<std::string> command_line;
};

int say_done(const Manner& manner, const Json& record) {
  restore_scenario(manner.folder);
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

int resume_from(const FoundCheckpoint& found, const Manner& manner, const Json& record, std::optional<int> threads) {
  tell_other_program(found);
  scenario_of(manner.folder); // says so if it cannot be read; it is written again
  Beginning beginning = beginning_of(found, record);
  if (threads) beginning.p.run.threads = *threads;
  beginning.lineage.push_back(event("resumed", found));
  return simulate(std::move(beginning), manner);
}

int resume(const Options& options) {
  Manner manner{
      .folder = options.folder, .json = options.json, .quiet = options.quiet, .command_line = options.command_line};
  if (!options.wall_time.empty()) manner.wall_time_limit = wall_time_of(options.wall_time);
  if (options.branch.any()) {
    fs::path name(options.folder);
    if (!name.has_filename()) name = name.parent_path();
    manner.folder = options.output.empty() ? name.string() + "-branch" : options.output;
    return branch(options.folder, options.branch, manner);
  }
  if (!options.output.empty())
    throw UsageError("-o is for branches: with --at, --set, --seed or --hours; a run goes on in its own folder");
  const Json record = record_of(options.folder);
  if (!options.branch.previous && is_done(options.folder, record)) return say_done(manner, record);
  return resume_from(last_checkpoint(options.folder, options.branch.previous), manner, record, options.branch.threads);
}

} // namespace

bool holds_run(const fs::path& folder, const Parameters& p) {
  const Json record = record_of(folder);
  return text_of(record, "configuration_hash") == configuration_hash(p);
}

int go_on(const Manner& manner, const Parameters& p) {
  const Json record = record_of(manner.folder);
  if (is_done(manner.folder, record)) return say_done(manner, record);
  if (has_checkpoint(manner.folder)) return resume_from(whole_checkpoint(manner.folder), manner, record, p.run.threads);
  return simulate({.s = initial_state(p), .p = p}, manner); // it was ended before its first checkpoint
}

void add_resume(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("resume", "Go on with a run from its last checkpoint, or branch off from it");
  verb->footer(
      "Without --at, --set, --seed and --hours the run goes on in its own folder, to the same bits as if it had never\n"
      "stopped. With one of them a branch is begun in a folder of its own: at the last checkpoint, or at the time of\n"
      "--at, which is reached from the closest checkpoint before. Its tables hold the run's history too, and\n"
      "\"lineage\" in its run.json says where it comes from.\n"
      "A checkpoint that is cut short, changed, of another scenario or format is refused; the one before is offered.\n"
      "With --at an earlier checkpoint is used instead, with a warning.");
  const auto options = std::make_shared<Options>();
  options->command_line = std::move(command_line);
  verb->add_option("FOLDER", options->folder, "Folder of a run")->required();
  verb->add_option("-o,--output", options->output, "Folder for a branch (default: <FOLDER>-branch)");
  verb->add_option("--at", options->branch.at, "Branch at this simulated time: \"3 h\"");
  verb->add_option("--set", options->branch.overrides, "Branch with key=value; may be repeated")
      ->allow_extra_args(false);
  verb->add_option("--seed", options->branch.seed, "Branch with another seed: run.seed");
  verb->add_option("--hours", options->branch.hours, "Branch with another end: run.duration");
  verb->add_option("--threads", options->branch.threads, "Threads, 0 for all; never changes a result");
  verb->add_option("--wall-time", options->wall_time, "Stop with a checkpoint after this time of the clock: \"2 h\"");
  verb->add_flag("--previous", options->branch.previous, "Go on, or branch, from checkpoint_prev.h5");
  verb->add_flag("--json", options->json, "Print the outcome as one JSON object");
  verb->add_flag("--quiet", options->quiet, "Show no progress; print only where the report is");
  verb->callback([options, &chosen] { chosen = [options] { return resume(*options); }; });
}

} // namespace matrigrate::apps
