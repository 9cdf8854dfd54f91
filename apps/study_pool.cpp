#include "apps/study_pool.hpp"

#include "apps/child.hpp"
#include "apps/progress.hpp"
#include "apps/stop_signal.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/stopped_run.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <list>
#include <thread>

namespace matrigrate::apps {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t largest_log = std::size_t{1} << 24;

/// A log that only one process at a time writes: it says that its run is being computed, here or on another node.
class Log {
public:
  explicit Log(const std::filesystem::path& file)
      : m_descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
    if (m_descriptor < 0)
      throw InputOutputError(
          fmt::format("{}: cannot be written: {}", file.string(), std::generic_category().message(errno)));
    m_mine = ::flock(m_descriptor, LOCK_EX | LOCK_NB) == 0 && ::ftruncate(m_descriptor, 0) == 0;
  }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log() { ::close(m_descriptor); } // the lock stays with the command that writes to it

  bool mine() const { return m_mine; }
  int descriptor() const { return m_descriptor; }

private:
  int m_descriptor;
  bool m_mine = false;
};

/// A run that is being computed.
struct Running {
  std::size_t run;
  Child child;
};

/// How far the pool is, on the standard error.
class PoolProgress {
public:
  PoolProgress(std::size_t total, int jobs, bool quiet)
      : m_total(total), m_jobs(static_cast<std::size_t>(jobs)), m_quiet(quiet),
        m_terminal(::isatty(STDERR_FILENO) == 1) {}
  PoolProgress(const PoolProgress&) = delete;
  PoolProgress& operator=(const PoolProgress&) = delete;
  ~PoolProgress() {
    if (m_drawn) print_error("\r\x1b[K");
  }

  void show(std::size_t ended, std::size_t failed) {
    const Clock::time_point now = Clock::now();
    if (m_quiet || now - m_last < (m_terminal ? Clock::duration(500ms) : Clock::duration(1min))) return;
    m_last = now;
    const double elapsed = std::chrono::duration<double>(now - m_start).count();
    const auto done = static_cast<double>(ended);
    const auto total = static_cast<double>(m_total);
    const bool known = ended >= std::min(m_jobs, m_total);
    const ProgressText text{.share = done / total,
                            .where = fmt::format("{} of {} runs", ended, m_total),
                            .left = known ? time_left(elapsed, done, total - done)
                                          : std::string("time left is known when the first runs end"),
                            .remark = failed > 0 ? fmt::format("{} not done", failed) : std::string()};
    if (m_terminal)
      print_error("\r\x1b[K" + progress_line(text, terminal_width()));
    else
      print_error(fmt::format("{}, {}{}{}\n", text.where, text.left, failed > 0 ? ", " : "", text.remark));
    m_drawn = m_terminal;
  }

private:
  std::size_t m_total;
  std::size_t m_jobs;
  bool m_quiet;
  bool m_terminal;
  bool m_drawn = false;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last = Clock::now();
};

class Pool {
public:
  Pool(const StudyFolder& study, const PoolOptions& options) : m_study(study), m_options(options) {}

  PoolOutcome compute(const std::vector<std::size_t>& runs) {
    const std::vector<std::size_t> open = sorted_out(runs);
    const StopSignal stop;
    PoolProgress progress(std::max<std::size_t>(1, open.size()), m_options.jobs, m_options.quiet);
    std::size_t next = 0;
    while (!m_running.empty() || (next < open.size() && !stopping())) {
      while (next < open.size() && !stopping() && std::ssize(m_running) < m_options.jobs) start(open[next++]);
      m_running.remove_if([&](Running& running) {
        const auto code = running.child.ended();
        if (code) see_end(running, *code);
        return code.has_value();
      });
      m_outcome.signal = StopSignal::received();
      if (stopping()) pass_on();
      progress.show(m_outcome.done_now + m_failed_now, m_failed_now);
      std::this_thread::sleep_for(5ms);
    }
    for (; next < open.size(); ++next) note(open[next], study::RunState::missing, "not started");
    return std::move(m_outcome);
  }

private:
  bool stopping() const { return m_outcome.signal != 0 || m_outcome.cannot_write; }

  void note(std::size_t run, study::RunState status, std::string reason) {
    m_outcome.troubles.push_back({run, status, std::move(reason)});
  }

  /// Those that are to be computed.
  std::vector<std::size_t> sorted_out(const std::vector<std::size_t>& runs) {
    std::vector<std::size_t> open;
    for (const std::size_t i : runs) {
      const study::Standing s = study::standing(m_study.folder, m_study.runs[i]);
      if (s.done())
        ++m_outcome.done_before;
      else if (s.failed_for_good() && !m_options.retry_failed)
        note(i, s.status, s.reason);
      else
        open.push_back(i);
    }
    return open;
  }

  void start(std::size_t i) {
    const study::Run& run = m_study.runs[i];
    const Log log(study::run_log(m_study.folder, run));
    if (!log.mine()) return note(i, study::RunState::running, "is being computed by another process");
    m_running.push_back({i, Child(run_command(m_study, run, m_options.threads), log.descriptor())});
  }

  void see_end(const Running& running, int code) {
    const study::Run& run = m_study.runs[running.run];
    const std::filesystem::path log = study::run_log(m_study.folder, run);
    const study::Standing s = study::standing(m_study.folder, run);
    if (code == done && s.done()) {
      ++m_outcome.done_now;
      std::filesystem::remove(log);
      return;
    }
    const std::string said = std::filesystem::exists(log) ? read_file(log, largest_log) : std::string();
    ++m_failed_now;
    const bool by_signal = code == requeue || code == interrupted;
    const bool broken = code == input_output && has_only_broken_checkpoints(study::run_folder(m_study.folder, run));
    if (code == input_output && !broken) m_outcome.cannot_write = true;
    if (by_signal && !stopping()) m_outcome.ended_by_signal = true;
    std::string reason =
        code > 128 && code != interrupted
            ? fmt::format("ended by signal {}{}", code - 128, code == 128 + SIGKILL ? "; too little memory?" : "")
        : broken ? std::string()
                 : s.reason;
    if (reason.empty())
      reason = said.empty() ? fmt::format("ended with exit code {}", code) : said.substr(0, said.find('\n'));
    note(running.run, by_signal ? study::RunState::interrupted : study::RunState::failed, std::move(reason));
  }

  void pass_on() {
    for (Running& running : m_running) running.child.pass_on(m_outcome.signal != 0 ? m_outcome.signal : SIGTERM);
  }

  const StudyFolder& m_study;
  PoolOptions m_options;
  PoolOutcome m_outcome;
  std::size_t m_failed_now = 0;
  std::list<Running> m_running;
};

} // namespace

int PoolOutcome::exit_code() const {
  if (signal != 0) return signal == SIGINT ? interrupted : requeue;
  if (cannot_write) return input_output;
  if (ended_by_signal) return requeue;
  const bool failed =
      std::ranges::any_of(troubles, [](const Trouble& t) { return t.status != study::RunState::running; });
  return failed ? numerical : done;
}

PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const PoolOptions& options) {
  return Pool(study, options).compute(runs);
}

} // namespace matrigrate::apps
