#include "apps/study/verbs.hpp"

#include "apps/shipped_pages.hpp"
#include "apps/terminal/progress.hpp"
#include "apps/terminal/stop_signal.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/text.hpp"
#include "parameters/version.hpp"
#include "run/estimate.hpp"
#include "run/folder_lock.hpp"
#include "run/folder_state.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <thread>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

/// What is said of some runs: {run, label, replicate, and what `more` says}.
template <class Told>
Json to_json(const StudyFolder& study, const std::vector<Told>& all, Json (*more)(const Told& told)) {
  Json list = Json::array();
  for (const Told& told : all) {
    const study::Run& run = study.runs[told.run];
    list.push_back({{"run", run.hash}, {"label", study.study.points[run.point].label}, {"replicate", run.replicate}});
    list.back().update(more(told));
  }
  return list;
}

Json to_json(const StudyFolder& study, const std::vector<study::Trouble>& troubles) {
  return to_json<study::Trouble>(study, troubles, [](const study::Trouble& t) -> Json {
    return {{"status", to_string(t.status)}, {"reason", t.reason}};
  });
}

std::string left_text(const std::optional<double>& left) {
  return left ? fmt::format("about {} left", wall_time_text(*left)) : "time left not known yet";
}

std::string running_text(const StudyFolder& study, const study::StudyProgress& progress) {
  std::string text;
  for (const study::RunningRun& r : progress.running)
    text += fmt::format("{:<12}{} ({}): {:.0f} %, {}\n", "running", title_of(study, study.runs[r.run]),
                        study.runs[r.run].hash, 100.0 * r.share, left_text(r.left));
  if (!progress.running.empty())
    text += fmt::format("all runs: {}, {} at a time\n", left_text(progress.left), progress.running.size());
  return text;
}

/// Writes all files of results of the study.
Collected collect(const StudyFolder& study) {
  Collected c = collect_tables(study);
  study::write_study_report(study, c, {.page_template = study_page_template()});
  return c;
}

/// What makes means doubtful, each on a line of its own before the closing line: runs lost at the rim, runs of several
/// builds.
void print_doubts(const StudyFolder& study, const std::vector<study::Result>& results) {
  for (const std::string& text : {rim_text(study.study, results), programs_text(results)})
    if (!text.empty()) print(text + "\n");
}

void print_outcome(const StudyOptions& options, const StudyFolder& study, const PoolOutcome& outcome,
                   const std::vector<study::Result>& results) {
  if (options.json)
    return print_json({{"folder", study.folder.string()},
                       {"runs", study.runs.size()},
                       {"done", outcome.done_before + outcome.done_now},
                       {"done_now", outcome.done_now},
                       {"exit_code", exit_code(outcome)},
                       {"ended_at_rim", std::ranges::count_if(results, study::ended_at_rim)},
                       {"not_done", to_json(study, outcome.troubles)}});
  const std::string list = troubles_text(study, outcome.troubles);
  if (!list.empty()) options.quiet ? print_error(list) : print(list);
  print_doubts(study, results);
  print(fmt::format("{} of {} runs done, {} of them now; results: {}\n", outcome.done_before + outcome.done_now,
                    study.runs.size(), outcome.done_now, (study.folder / "results.csv").string()));
}

/// Says which runs were done and are to be computed again, since their folders are no longer there.
void tell_gone(const StudyOptions& options, const StudyFolder& study) {
  std::vector<study::Result> now;
  for (const study::Run& run : study.runs) now.push_back({run, study::standing(study.folder, run), {}});
  const std::vector<std::string> gone = gone_runs(study, now);
  if (gone.empty() || options.quiet || options.json) return;
  print_error(fmt::format("{}: these runs were done and are not any more; they are computed again:\n  {}\n",
                          (study.folder / "results.csv").string(), run::listed(gone, "\n  ")));
}

/// Whether somebody must look at such a run.
bool is_trouble(study::RunState state) {
  return state == study::RunState::failed || state == study::RunState::interrupted || state == study::RunState::damaged;
}

/// Runs that were done before, of which a file is damaged.
void add_damaged(const StudyFolder& study, const std::vector<study::Result>& results, PoolOutcome& outcome) {
  for (const study::Result& r : results)
    if (r.standing.status == study::RunState::damaged) {
      const auto own = std::ranges::find(study.runs, r.run.hash, &study::Run::hash);
      outcome.troubles.push_back(
          {static_cast<std::size_t>(own - study.runs.begin()), r.standing.status, r.standing.reason});
      if (outcome.done_before > 0) --outcome.done_before;
    }
}

} // namespace

PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const study::PoolOptions& options,
                    bool quiet) {
  std::optional<StopSignal> signals;
  std::optional<Progress> progress;
  return study::compute(study, runs, options, [&](std::size_t all, std::size_t ended, std::size_t failed) {
    if (!progress) {
      signals.emplace();
      progress.emplace(quiet);
    }
    progress->show([&](double elapsed) {
      const auto done = static_cast<double>(ended), total = static_cast<double>(all);
      const bool known = ended >= std::min(static_cast<std::size_t>(options.jobs), all);
      ProgressText text{.share = done / total,
                        .where = fmt::format("{} of {} runs", ended, all),
                        .left = known ? time_left(elapsed, done, total - done)
                                      : std::string("time left is known when the first runs end"),
                        .remark = failed > 0 ? fmt::format("{} not done", failed) : std::string()};
      text.line = fmt::format("{}, {}{}{}", text.where, text.left, failed > 0 ? ", " : "", text.remark);
      return text;
    });
    return StopSignal::received();
  });
}

int exit_code(const PoolOutcome& outcome) {
  if (outcome.signal != 0) return outcome.signal == SIGINT ? interrupted : requeue;
  if (outcome.cannot_write) return input_output;
  if (outcome.ended_by_signal) return requeue;
  if (std::ranges::any_of(outcome.troubles, [](const auto& t) { return t.status == study::RunState::damaged; }))
    return input_output;
  const bool failed = std::ranges::any_of(outcome.troubles,
                                          [](const study::Trouble& t) { return t.status != study::RunState::running; });
  return failed ? numerical : done;
}

std::string troubles_text(const StudyFolder& study, const std::vector<study::Trouble>& troubles) {
  constexpr std::size_t most = 100;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, troubles.size()); ++i) {
    const study::Trouble& t = troubles[i];
    text += fmt::format("{:<12}{} ({}): {}\n", to_string(t.status), title_of(study, study.runs[t.run]),
                        study.runs[t.run].hash, t.reason);
  }
  if (troubles.size() > most) text += fmt::format("... and {} more\n", troubles.size() - most);
  return text;
}

int job_count(int wanted) {
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

StudyFolder read_study_file(const StudyOptions& options) {
  study::Changes changes{.overrides = {}, .replicates = {}, .more = start_rules()};
  const auto shipped = std::ranges::find(study::shipped_studies(), options.file, &study::ShippedStudy::name);
  const bool by_name = shipped != study::shipped_studies().end() && !std::filesystem::exists(options.file);
  if (!by_name) changes.labels_of = study::other_studies(std::filesystem::path(options.file).parent_path());
  study::Study study = by_name ? study::parse_study(shipped->text, options.file + ".toml", ".", changes)
                               : study::read_study(options.file, changes);
  return planned(std::move(study), options.folder.empty() ? study::default_study_folder(options.file)
                                                          : std::filesystem::path(options.folder));
}

int run_study(const StudyOptions& options) {
  const StudyFolder study = read_study_file(options);
  make_study_folder(study);
  const FolderLock lock(study.folder, FolderLock::Kind::alone);
  write_study(study);
  for (const std::string& note : {closures_of(study.study.base).note, run::note_of_scenario(study.study.base)})
    if (!note.empty()) print_warning(note);
  tell_gone(options, study);
  std::vector<std::size_t> all(study.runs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  PoolOutcome outcome = compute(study, all, {.jobs = job_count(options.jobs), .retry_failed = options.retry_failed},
                                options.quiet || options.json);
  std::vector<study::Result> results;
  std::string refusal;
  try {
    if (!outcome.cannot_write) results = collect(study).results;
  } catch (const InputOutputError& trouble) { // what was computed is there
    refusal = trouble.what();
  }
  add_damaged(study, results, outcome);
  print_outcome(options, study, outcome, results);
  if (refusal.empty()) return exit_code(outcome);
  print_error(refusal + "\n");
  return exit_code(outcome) == done ? static_cast<int>(input_output) : exit_code(outcome);
}

int show_status(const StudyOptions& options) {
  const StudyFolder study = study::open_study(options.folder);
  std::vector<study::Standing> standings;
  for (const study::Run& run : study.runs) standings.push_back(study::standing(study.folder, run));
  const study::StudyProgress progress = progress_of(study, standings);
  for (const study::RunningRun& run : progress.running) standings[run.run].status = study::RunState::running;
  std::vector<study::Trouble> troubles;
  std::vector<study::Result> done_runs;
  std::map<std::string, std::size_t> count;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    study::Standing& s = standings[i];
    if (s.status != study::RunState::running) s = results(study.study, {study.runs[i]}, study.folder).front().standing;
    if (s.done()) done_runs.push_back({study.runs[i], s, {}});
    if (is_trouble(s.status)) troubles.push_back({i, s.status, s.reason});
    ++count[std::string(to_string(s.status))];
  }
  if (options.json) {
    print_json({{"folder", options.folder},
                {"runs", study.runs.size()},
                {"count", count},
                {"running",
                 to_json<study::RunningRun>(study, progress.running,
                                            [](const auto& r) -> Json {
                                              return {{"share", r.share}, {"left_s", r.left ? Json(*r.left) : Json()}};
                                            })},
                {"left_s", progress.left ? Json(*progress.left) : Json()},
                {"builds", programs_of(done_runs)},
                {"not_done", to_json(study, troubles)}});
    return done;
  }
  print(fmt::format("{} runs:", study.runs.size()));
  for (const auto& [status, n] : count) print(fmt::format(" {} {}", n, status));
  print("\n" + running_text(study, progress) + troubles_text(study, troubles));
  if (const std::string text = programs_text(done_runs); !text.empty()) print(text + "\n");
  return done;
}

int collect_study(const StudyOptions& options) {
  const StudyFolder study = study::open_study(options.folder);
  const Collected collected = collect(study);
  PoolOutcome damaged;
  add_damaged(study, collected.results, damaged);
  const auto finished = std::ranges::count_if(collected.results, [](const auto& r) { return r.standing.done(); });
  if (options.json) {
    Json files{"results.csv", "groups.csv", "statistics.csv", "correlations.csv", "report.html"};
    for (const char* name : {"paths.csv", "msd.csv", "adhesions.csv"})
      if (std::filesystem::exists(study.folder / name)) files.push_back(name);
    if (!collected.claims.empty()) files.push_back("claims.csv");
    print_json({{"folder", options.folder},
                {"runs", study.runs.size()},
                {"done", finished},
                {"ended_at_rim", std::ranges::count_if(collected.results, study::ended_at_rim)},
                {"files", files},
                {"damaged", to_json(study, damaged.troubles)}});
    return exit_code(damaged);
  }
  if (!options.quiet) print(collected_text(study, collected));
  print_doubts(study, collected.results);
  print_error(troubles_text(study, damaged.troubles));
  print(fmt::format("{} of {} runs done; results: {}\n", finished, study.runs.size(),
                    (study.folder / "results.csv").string()));
  return exit_code(damaged);
}

} // namespace matrigrate::apps
