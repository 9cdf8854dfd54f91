#include "run/simulate.hpp"

#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "base/platform.hpp"
#include "base/text.hpp"
#include "parameters/version.hpp"
#include "run/estimate.hpp"
#include "run/run_folder.hpp"
#include "simulation/march.hpp"
#include "simulation/simulation.hpp"
#include "store/checkpoint.hpp"

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <memory>
#include <new>
#include <utility>

namespace matrigrate::run {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Tells the observer when the steps begin and end.
class Steps {
public:
  Steps(RunObserver& observer, double t, double t_end) : m_observer(observer) { m_observer.begin_steps(t, t_end); }
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;
  ~Steps() { m_observer.end_steps(); }

private:
  RunObserver& m_observer;
};

/// One run, from its start to however it ends.
class Computation {
public:
  Computation(RunStart start, const RunOptions& options, RunObserver& observer)
      : m_options(options), m_observer(observer), m_p(start.p), m_before(start.before),
        m_new(start.memory.rows.empty()), m_earlier_march_time(start.memory.march_wall_time),
        m_simulation(std::make_unique<Simulation>(m_before ? m_before->p : m_p, std::move(start.s))) {
    m_simulation->w.health = start.memory.counts;
    m_record.configuration_hash = configuration_hash(m_p);
    m_record.command_line = options.command_line;
    m_record.scenario = std::move(start.scenario);
    if (m_record.scenario.empty())
      m_record.scenario = scenario_name({{"command_line", options.command_line}}, options.folder);
    m_record.commands = std::move(start.commands);
    if (m_record.commands.empty()) m_record.commands.push_back(options.command_line);
    m_record.lineage = std::move(start.lineage);
    m_record.earlier_wall_time = start.earlier_wall_time;
    m_record.steps_without_bias = start.steps_without_bias;
    m_folder.emplace(options.folder, m_p, m_record, *m_simulation, std::move(start.memory), start.frames_from);
    m_record.lost_frames = m_folder->lost_frames();
    if (m_record.lost_frames.count == 0) return;
    m_folder->write_record(m_record);
    m_observer.warn(store::to_text(m_record.lost_frames));
  }

  RunOutcome compute() {
    try {
      march_to_end();
      const RunStatus status = m_record.status();
      m_folder->see_last(m_simulation->s, m_simulation->w);
      m_record.lost_frames = m_folder->lost_frames();
      const State last = std::move(m_simulation->s);
      m_simulation.reset();         // frees the memory that all frames together need,
      platform::give_back_memory(); // and gives it back
      m_record.trajectory_hash = m_folder->trajectory_hash();
      const std::vector<CellResult> cells = m_folder->finish(
          {.s = last, .status = status_text(), .record = m_record, .page_template = m_options.page_template});
      m_record.note_end();
      if (status == RunStatus::done) m_record.files = result_fingerprints(m_options.folder);
      m_folder->write_record(m_record);
      if (status == RunStatus::done) m_folder->tidy();
      return {.folder = m_options.folder,
              .end = *m_record.ended,
              .computed = true,
              .record = to_json(m_record, m_p),
              .sentence = status_text(),
              .p = m_p,
              .cells = cells};
    } catch (const InputOutputError& error) {
      record_trouble(error.what(), RunEnd::cannot_write);
      throw InputOutputError(fmt::format("{}; {}", error.what(), safe_text()));
    } catch (const std::bad_alloc&) {
      record_trouble("not enough memory", RunEnd::no_memory);
      throw;
    }
  }

private:
  void march_to_end() {
    State& s = m_simulation->s;
    Workspace& w = m_simulation->w;
    const Steps steps(m_observer, s.t, m_p.run.duration);
    const Clock::time_point start = Clock::now();
    const auto note_time = [&] {
      m_record.steps = s.step;
      m_record.t = s.t;
      m_record.march_wall_time = m_earlier_march_time + seconds_since(start);
    };
    const auto each_step = [&](const State& now) {
      note_time();
      if (w.without_bias > 0) ++m_record.steps_without_bias;
      m_folder->see(now, w, m_record);
      m_observer.step(now);
      m_stop = m_observer.stop_request();
      return !m_stop && seconds_since(m_begin) < m_options.wall_time_limit;
    };
    try {
      m_folder->keep_checkpoints(!m_before);
      if (m_new) m_folder->begin(s, w);
      if (m_before) march_before(each_step);
      if (has_branched()) march_after(each_step);
      note_time();
      note_end();
    } catch (const NumericalFailure& failure) {
      note_time();
      m_record.ended = RunEnd::numerical_failure;
      m_record.cause = failure.cause();
      m_record.reason = fmt::format("{}; {}", failure.what(), last_good_text());
    }
    m_record.trajectory_hash = m_folder->trajectory_hash();
  }

  /// The part of a branch's run that has no checkpoint yet.
  void march_before(const std::function<bool(const State&)>& each_step) {
    m_simulation->march(m_before->until, {}, each_step);
    m_folder->keep_checkpoints(true);
    if (!has_branched()) return;
    m_simulation->change(m_p);
    m_folder->write_checkpoint(m_simulation->s, m_simulation->w, m_record.march_wall_time, true);
  }

  /// To the end. Where it lies within a step, a checkpoint at the step before it is what a longer run goes on from.
  void march_after(const std::function<bool(const State&)>& each_step) {
    State& s = m_simulation->s;
    Workspace& w = m_simulation->w;
    const double t_end = m_p.run.duration;
    m_has_ended = m_simulation->march_within(t_end, each_step);
    if (!m_has_ended || !is_before(s, m_p, t_end)) return;
    m_folder->write_checkpoint(s, w, m_record.march_wall_time);
    shorten_last_step(s, m_simulation->p, w, t_end);
    m_folder->note_step(w);
    m_observer.step(s);
  }

  bool has_branched() const { return !m_before || m_simulation->s.t >= m_before->until; }

  void note_end() {
    if (has_branched()) m_folder->write_checkpoint(m_simulation->s, m_simulation->w, m_record.march_wall_time);
    m_folder->wait();
    m_record.ended = m_has_ended                        ? RunEnd::completed
                     : m_stop == StopRequest::user      ? RunEnd::stopped_by_user
                     : m_stop == StopRequest::terminate ? RunEnd::told_to_terminate
                                                        : RunEnd::out_of_wall_time;
    if (!m_has_ended) m_record.reason = fmt::format("stopped by {}; {}", stop_text(*m_record.ended), safe_text());
  }

  static const char* stop_text(RunEnd end) {
    if (end == RunEnd::stopped_by_user) return "Ctrl-C";
    return end == RunEnd::told_to_terminate ? "a signal to terminate" : "the limit of wall time";
  }

  /// The results that the user still has.
  std::string safe_text() const {
    if (!m_options.folder_is_kept) return "nothing of it is kept";
    if (!m_folder->safe_until()) return "there is no checkpoint yet";
    std::error_code error;
    const auto is_there = [&](std::string_view name) {
      return std::filesystem::exists(m_options.folder / name, error);
    };
    if (is_there(store::checkpoint_name))
      return fmt::format("results up to {} are safe in {}; continue with: matrigrate resume {}",
                         time_text(*m_folder->safe_until()), store::checkpoint_name, m_options.folder.string());
    if (is_there(store::previous_checkpoint_name))
      return fmt::format("only the previous checkpoint is left, {}; continue with: matrigrate resume {}",
                         store::previous_checkpoint_name, m_options.folder.string());
    return "the checkpoint is gone as well";
  }

  std::string last_good_text() const {
    if (!m_options.folder_is_kept) return "nothing of it is kept";
    if (!m_folder->safe_until()) return "there is no checkpoint yet";
    return fmt::format("the last good checkpoint is {}, at {}", store::checkpoint_name,
                       time_text(*m_folder->safe_until()));
  }

  /// How the run ended, in a sentence.
  std::string status_text() const {
    const std::string reached = fmt::format("{} of {}", time_text(m_record.t), time_text(m_p.run.duration));
    const std::string bias = bias_sentence(to_json(m_record, m_p));
    const std::string lost =
        (m_record.lost_frames.count == 0 ? "" : fmt::format(" {}.", store::to_text(m_record.lost_frames)))
        + (bias.empty() ? "" : fmt::format(" Note: {}.", bias));
    if (m_record.status() == RunStatus::done)
      return fmt::format("Done: {}, {} steps.{}", time_text(m_record.t), m_record.steps, lost);
    return fmt::format("{} after {}: {}.{}", m_record.status() == RunStatus::failed ? "Failed" : "Interrupted", reached,
                       m_record.reason, lost);
  }

  /// Where a file cannot be written or memory ends, run.json should say so too, if it can still be written.
  void record_trouble(const std::string& reason, RunEnd end) {
    m_record.ended = end;
    m_record.reason = fmt::format("{}; {}", reason, safe_text());
    m_record.note_end();
    try {
      m_folder->write_record(m_record);
    } catch (const InputOutputError&) { // the first trouble is the one to tell
    }
  }

  const Clock::time_point m_begin = Clock::now(); ///< before the matrix is built
  const RunOptions& m_options;
  RunObserver& m_observer;
  Parameters m_p; ///< of the run; those of the simulation are others until a branch begins, and from changes on
  std::optional<BranchPoint> m_before;
  bool m_new;
  double m_earlier_march_time;
  std::unique_ptr<Simulation> m_simulation;
  RunRecord m_record;
  std::optional<RunFolder> m_folder;
  std::optional<StopRequest> m_stop;
  bool m_has_ended = false;
};

} // namespace

RunOutcome run(RunStart start, const RunOptions& options, RunObserver& observer) {
  const ThreadLimit limit(threads_of(start.p, start.s.ecm.size()));
  observer.begin();
  if (const std::string note = closures_of(start.p).note; !note.empty()) observer.warn(note);
  return Computation(std::move(start), options, observer).compute();
}

} // namespace matrigrate::run
