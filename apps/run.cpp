#include "apps/progress.hpp"
#include "apps/run_folder.hpp"
#include "apps/stop_signal.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/cell_picture.hpp"
#include "io/run_files.hpp"
#include "parameters/read.hpp"
#include "simulation/advance.hpp"
#include "simulation/start.hpp"
#include "simulation/step_limits.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <chrono>
#include <memory>
#include <optional>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string file;
  std::string folder;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> seed;
  std::optional<double> hours;
  std::optional<int> threads;
  bool force = false;
  bool json = false;
  bool quiet = false;
  std::vector<std::string> command_line;
};

/// The options that stand for a parameter are overrides like any other, and checked like them.
std::vector<std::string> all_overrides(const Options& options) {
  std::vector<std::string> all = options.overrides;
  if (options.hours) all.push_back(fmt::format("run.duration={} h", *options.hours));
  if (options.seed) all.push_back(fmt::format("run.seed={}", *options.seed));
  if (options.threads) all.push_back(fmt::format("run.threads={}", *options.threads));
  return all;
}

std::string default_folder(const std::string& file, const Parameters& p) {
  return fmt::format("{}-seed{}", std::filesystem::path(file).stem().string(), p.run.seed);
}

std::string remark(const State& s) {
  return fmt::format("{} protrusion{} alive of {}", s.protrusions.size(), s.protrusions.size() == 1 ? "" : "s",
                     s.initiated);
}

/// Marches to the end, a signal or a failure, and says in the record which it was.
void march_to_end(State& s, const Parameters& p, Workspace& w, RunFolder& folder, RunRecord& record, bool quiet) {
  const StopSignal stop;
  Progress progress(p.run.duration, quiet);
  const auto start = std::chrono::steady_clock::now();
  const auto note_time = [&] {
    record.steps = s.step;
    record.t = s.t;
    record.march_wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    record.trajectory_hash = folder.trajectory_hash();
  };
  try {
    march(s, p, w, p.run.duration, {}, [&](const State& now) {
      note_time();
      folder.see(now, w, record);
      progress.show(now.t, remark(now));
      return StopSignal::received() == 0;
    });
    const bool stopped = StopSignal::received() != 0 && s.t < p.run.duration - 0.5 * p.run.time_step;
    record.status = stopped ? "interrupted" : "done";
    record.exit_code = !stopped ? done : StopSignal::received() == SIGINT ? interrupted : requeue;
    if (stopped)
      record.reason = fmt::format("stopped by {}; without a checkpoint, so that it can only be started again",
                                  StopSignal::received() == SIGINT ? "Ctrl-C" : "a signal to terminate");
  } catch (const NumericalFailure& failure) {
    record.status = "failed";
    record.exit_code = numerical;
    record.reason = failure.what();
  }
  note_time();
}

/// How the run ended, in a sentence.
std::string status_text(const RunRecord& record, const Parameters& p) {
  const std::string reached = fmt::format("{} of {}", io::time_text(record.t), io::time_text(p.run.duration));
  if (record.status == "done") return fmt::format("Done: {}, {} steps.", io::time_text(record.t), record.steps);
  return fmt::format("{} after {}: {}.", record.status == "failed" ? "Failed" : "Interrupted", reached, record.reason);
}

void print_outcome(const Options& options, const RunRecord& record, const Parameters& p, const ReadOuts& readouts) {
  const std::filesystem::path folder(options.folder);
  if (options.json) {
    Json all{{"folder", options.folder}, {"report", (folder / "report.html").string()}};
    all["summary"] = Json::parse(io::summary_json(readouts));
    all.update(to_json(record, p));
    print(all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return;
  }
  if (!options.quiet) {
    print(status_text(record, p) + "\n\n");
    for (const io::NamedValue& v : io::named_values(readouts))
      print(fmt::format("  {:<50}{:>10}\n", v.meaning, io::readable(v.value)));
    print("\n");
  }
  if (options.quiet && record.status != "done")
    print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::bad, Stream::err), status_text(record, p)));
  print(fmt::format("open {}\n", (folder / "report.html").string()));
}

/// Where a file cannot be written or memory ends, run.json should say so too, if it can still be written.
void record_trouble(const RunFolder& folder, RunRecord& record, const std::string& reason, int exit_code) {
  record.status = "failed";
  record.reason = reason;
  record.exit_code = exit_code;
  record.end = std::chrono::system_clock::now();
  try {
    folder.write_record(record);
  } catch (const InputOutputError&) { // the first trouble is the one to tell
  }
}

int run(Options options) {
  const Parameters p = read_parameters(options.file, all_overrides(options));
  require_stable_step(p);
  const auto threads = static_cast<std::size_t>(p.run.threads > 0 ? p.run.threads : tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  State s = initial_state(p);
  Workspace w(s, p);
  if (options.folder.empty()) options.folder = default_folder(options.file, p);
  make_output_folder(options.folder, options.force);

  RunRecord record;
  record.configuration_hash = configuration_hash(p);
  record.command_line = options.command_line;
  RunFolder folder(options.folder, p, record, s, w);
  try {
    march_to_end(s, p, w, folder, record, options.quiet || options.json);
    folder.finish(s, w, status_text(record, p));
    record.trajectory_hash = folder.trajectory_hash();
    record.end = std::chrono::system_clock::now();
    folder.write_record(record);
  } catch (const InputOutputError& error) {
    record_trouble(folder, record, error.what(), input_output);
    throw;
  } catch (const std::bad_alloc&) {
    record_trouble(folder, record, "not enough memory", numerical);
    throw;
  }
  print_outcome(options, record, p, folder.readouts());
  return *record.exit_code;
}

} // namespace

void add_run(CLI::App& app, Action& chosen, std::vector<std::string> command_line) {
  CLI::App* verb = app.add_subcommand("run", "Simulate one cell; write tracks, protrusions, read-outs and pictures");
  verb->footer(
      "Writes scenario.resolved.toml, run.json, tracks.csv, protrusions.csv, health.csv, msd.csv, summary.csv,\n"
      "summary.json, snapshots/t_<seconds>s.svg, snapshots.svg and report.html. Rows are written as they come. "
      "Running\n"
      "scenario.resolved.toml again gives the same bits, and so the same trajectory_hash in run.json.\n"
      "--json prints {folder, report, summary: {read-outs}, and all keys of run.json}.\n"
      "Ctrl-C or a signal to terminate ends the run after its current step, with all files written up to there and "
      "the\n"
      "exit code 130 or 75. There are no checkpoints yet: such a run can be started again, but not resumed.");
  const auto options = std::make_shared<Options>();
  options->command_line = std::move(command_line);
  verb->add_option("FILE", options->file, "A scenario file")->required();
  verb->add_option("-o,--output", options->folder, "Folder for the results (default: <scenario>-seed<N>)");
  verb->add_option("--seed", options->seed, "Seed of the random numbers: run.seed");
  verb->add_option("--hours", options->hours, "Simulated time in hours: run.duration");
  verb->add_option("--threads", options->threads, "Threads, 0 for all: run.threads; never changes a result");
  verb->add_option("--set", options->overrides, "key=value, over the file; may be repeated")->allow_extra_args(false);
  verb->add_flag("--force", options->force,
                 "Write into a folder that is not empty: files of the same name are replaced, others stay");
  verb->add_flag("--json", options->json, "Print the outcome as one JSON object");
  verb->add_flag("--quiet", options->quiet, "Show no progress; print only where the report is");
  verb->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

} // namespace matrigrate::apps
