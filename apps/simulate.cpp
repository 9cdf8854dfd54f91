#include "apps/simulate.hpp"

#include "apps/progress.hpp"
#include "apps/run_folder.hpp"
#include "apps/stop_signal.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/time_text.hpp"
#include "parameters/units.hpp"
#include "simulation/advance.hpp"
#include "store/checkpoint.hpp"
#include "store/run_files.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <malloc.h>

#include <chrono>
#include <new>
#include <stdexcept>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::string remark(const State& s) {
  return fmt::format("{} protrusion{} now, {} so far", s.protrusions.size(), s.protrusions.size() == 1 ? "" : "s",
                     s.initiated);
}

/// One simulation, from its beginning to however it ends.
class Simulation {
public:
  Simulation(Beginning beginning, const Manner& manner)
      : m_manner(manner), m_s(std::move(beginning.s)), m_p(beginning.p), m_before(beginning.before),
        m_new(beginning.memory.rows.empty()), m_earlier_march_time(beginning.memory.march_wall_time),
        m_counts(beginning.memory.counts) {
    m_record.configuration_hash = configuration_hash(m_p);
    m_record.command_line = manner.command_line;
    m_record.scenario = std::move(beginning.scenario);
    if (m_record.scenario.empty())
      m_record.scenario = scenario_name({{"command_line", manner.command_line}}, manner.folder);
    m_record.commands = std::move(beginning.commands);
    if (m_record.commands.empty()) m_record.commands.push_back(manner.command_line);
    m_record.lineage = std::move(beginning.lineage);
    m_record.earlier_wall_time = beginning.earlier_wall_time;
    m_folder.emplace(manner.folder, m_p, m_record, m_s, std::move(beginning.memory), beginning.frames_from);
    m_record.lost_frames = m_folder->lost_frames();
    if (m_record.lost_frames.count == 0) return;
    m_folder->write_record(m_record);
    print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::warning, Stream::err),
                            io::to_text(m_record.lost_frames)));
  }

  /// @return the exit code
  int carry_out() {
    try {
      march_to_end();
      const bool failed = m_record.status == "failed";
      m_folder->see_last(m_s, *m_w, m_record.status == "interrupted");
      m_record.lost_frames = m_folder->lost_frames();
      m_w.reset();      // frees the memory that all frames together need,
      ::malloc_trim(0); // and gives it back
      m_record.trajectory_hash = m_folder->trajectory_hash();
      m_folder->finish(m_s, status_text(), failed, m_record);
      m_record.end = std::chrono::system_clock::now();
      m_folder->write_record(m_record);
      if (m_record.status == "done") m_folder->remove_log();
    } catch (const InputOutputError& error) {
      record_trouble(error.what(), input_output);
      throw InputOutputError(fmt::format("{}; {}", error.what(), safe_text()));
    } catch (const std::bad_alloc&) {
      record_trouble("not enough memory", numerical);
      throw;
    }
    print_outcome();
    return *m_record.exit_code;
  }

private:
  void work_with(const Parameters& p) {
    m_w.emplace(m_s, p);
    m_w->health = m_counts;
  }

  void march_to_end() {
    Progress progress(m_s.t, m_p.run.duration, m_manner.quiet || m_manner.json);
    const Clock::time_point start = Clock::now();
    const auto note_time = [&] {
      m_record.steps = m_s.step;
      m_record.t = m_s.t;
      m_record.march_wall_time = m_earlier_march_time + seconds_since(start);
    };
    const auto each_step = [&](const State& now) {
      note_time();
      m_folder->see(now, *m_w, m_record);
      progress.show(now.t, remark(now));
      return StopSignal::received() == 0 && seconds_since(start) < m_manner.wall_time_limit;
    };
    try {
      if (m_before) march_before(each_step);
      if (!m_before || m_s.t >= m_before->until) {
        work_with(m_p);
        if (m_new && !m_before) m_folder->begin(m_s, *m_w);
        if (m_before) m_folder->write_checkpoint(m_s, *m_w, m_record.march_wall_time);
        march(m_s, m_p, *m_w, m_p.run.duration, {}, each_step);
      }
      note_time();
      note_end(seconds_since(start));
    } catch (const NumericalFailure& failure) {
      note_time();
      m_record.status = "failed";
      m_record.exit_code = numerical;
      m_record.reason = fmt::format("{}; {}", failure.what(), last_good_text());
    }
    m_record.trajectory_hash = m_folder->trajectory_hash();
  }

  /// The part of a branch's run that has no checkpoint yet.
  void march_before(const std::function<bool(const State&)>& each_step) {
    m_folder->keep_checkpoints(false);
    work_with(m_before->p);
    if (m_new) m_folder->begin(m_s, *m_w);
    march(m_s, m_before->p, *m_w, m_before->until, {}, each_step);
    m_counts = m_w->health;
    m_folder->keep_checkpoints(true);
  }

  void note_end(double wall_time) {
    const bool stopped = m_s.t < m_p.run.duration - 0.5 * m_p.run.time_step;
    if (!m_before || m_s.t >= m_before->until) m_folder->write_checkpoint(m_s, *m_w, m_record.march_wall_time);
    m_record.status = stopped ? "interrupted" : "done";
    m_record.exit_code = !stopped ? done : StopSignal::received() == SIGINT ? interrupted : requeue;
    if (!stopped) return;
    const bool limit = wall_time >= m_manner.wall_time_limit && StopSignal::received() == 0;
    m_record.reason = fmt::format("stopped by {}; {}",
                                  limit                              ? "the limit of wall time"
                                  : StopSignal::received() == SIGINT ? "Ctrl-C"
                                                                     : "a signal to terminate",
                                  safe_text());
  }

  /// What the user still has.
  std::string safe_text() const {
    if (!m_folder->safe_until()) return "there is no checkpoint yet";
    std::error_code error;
    if (!std::filesystem::exists(m_manner.folder / io::checkpoint_name, error)) return "the checkpoint is gone as well";
    return fmt::format("all up to {} is safe in {}; go on with: matrigrate resume {}",
                       time_text(*m_folder->safe_until()), io::checkpoint_name, m_manner.folder.string());
  }

  std::string last_good_text() const {
    if (!m_folder->safe_until()) return "there is no checkpoint yet";
    return fmt::format("the last good checkpoint is {}, at {}", io::checkpoint_name,
                       time_text(*m_folder->safe_until()));
  }

  /// How the run ended, in a sentence.
  std::string status_text() const {
    const std::string reached = fmt::format("{} of {}", time_text(m_record.t), time_text(m_p.run.duration));
    const std::string lost =
        m_record.lost_frames.count == 0 ? "" : fmt::format(" {}.", io::to_text(m_record.lost_frames));
    if (m_record.status == "done")
      return fmt::format("Done: {}, {} steps.{}", time_text(m_record.t), m_record.steps, lost);
    return fmt::format("{} after {}: {}.{}", m_record.status == "failed" ? "Failed" : "Interrupted", reached,
                       m_record.reason, lost);
  }

  void print_outcome() const {
    const std::string report = (m_manner.folder / "report.html").string();
    if (m_manner.json) {
      Json all{{"folder", m_manner.folder.string()}, {"report", report}};
      all["summary"] = Json::parse(io::summary_json(m_folder->readouts()));
      all.update(to_json(m_record, m_p));
      print(all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
      return;
    }
    if (!m_manner.quiet) {
      print(status_text() + "\n\n");
      for (const io::NamedValue& v : io::shown_values(m_folder->readouts(), m_p))
        print(fmt::format("  {:<50}{:>10}\n", v.meaning, io::readable(v.value)));
      print("\n");
    }
    if (m_manner.quiet && m_record.status != "done")
      print_error(fmt::format("{} {}\n", coloured("matrigrate:", Colour::bad, Stream::err), status_text()));
    print(fmt::format("open {}\n", report));
  }

  /// Where a file cannot be written or memory ends, run.json should say so too, if it can still be written.
  void record_trouble(const std::string& reason, int exit_code) {
    m_record.status = "failed";
    m_record.reason = fmt::format("{}; {}", reason, safe_text());
    m_record.exit_code = exit_code;
    m_record.end = std::chrono::system_clock::now();
    try {
      m_folder->write_record(m_record);
    } catch (const InputOutputError&) { // the first trouble is the one to tell
    }
  }

  StopSignal m_stop; // before there is a folder, and until its last file is written
  Manner m_manner;
  State m_s;
  Parameters m_p;
  std::optional<Before> m_before;
  bool m_new;
  double m_earlier_march_time;
  StepHealth m_counts;
  RunRecord m_record;
  std::optional<RunFolder> m_folder;
  std::optional<Workspace> m_w;
};

} // namespace

int simulate(Beginning beginning, const Manner& manner) {
  const int asked = beginning.p.run.threads;
  const auto threads = static_cast<std::size_t>(asked > 0 ? asked : tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return Simulation(std::move(beginning), manner).carry_out();
}

double wall_time_of(const std::string& text) {
  try {
    const units::Quantity quantity = units::parse_quantity(text);
    const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "s" : quantity.unit);
    const double seconds = units::to_internal(quantity.number, unit);
    if (unit.dimension == units::Dimension{.time = 1000} && seconds > 0.0) return seconds;
  } catch (const std::invalid_argument&) { // said below
  }
  throw UsageError(fmt::format("\"{}\" is no time: something like \"90 s\" or \"2 h\" is wanted", text));
}

} // namespace matrigrate::apps
