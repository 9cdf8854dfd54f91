#include "study_runs/pool.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "base/process.hpp"
#include "run/estimate.hpp"
#include "run/resume.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <list>
#include <thread>

namespace matrigrate::study {

namespace {

using namespace std::chrono_literals;
using run::exit_code;
using run::RunEnd;

constexpr std::size_t largest_log = std::size_t{1} << 24;

/// A log that only one process at a time writes: it says that its run is being computed, here or on another node.
class Log {
public:
  explicit Log(const std::filesystem::path& file)
      : m_descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
    if (m_descriptor < 0)
      throw InputOutputError(
          fmt::format("{}: cannot be written: {}", file.string(), std::generic_category().message(errno)));
    m_mine = platform::lock(m_descriptor, platform::Lock::alone) == 0 && ::ftruncate(m_descriptor, 0) == 0;
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

class Pool {
public:
  Pool(const StudyFolder& study, const PoolOptions& options, const PoolWatch& watch)
      : m_study(study), m_options(options), m_watch(watch) {}

  PoolOutcome compute(const std::vector<std::size_t>& runs) {
    const std::vector<std::size_t> open = sorted_out(runs);
    const auto look = [&] { m_outcome.signal = m_watch(open.size(), m_outcome.done_now + m_failed_now, m_failed_now); };
    if (!open.empty()) {
      m_threads = threads_of_each(open.size());
      look();
    }
    std::size_t next = 0;
    while (!m_running.empty() || (next < open.size() && !stopping())) {
      while (next < open.size() && !stopping() && std::ssize(m_running) < m_options.jobs) start(open[next++]);
      m_running.remove_if([&](Running& running) {
        const auto code = running.child.ended();
        if (code) see_end(running, *code);
        return code.has_value();
      });
      look();
      if (stopping())
        for (Running& running : m_running) running.child.pass_on(m_outcome.signal != 0 ? m_outcome.signal : SIGTERM);
      std::this_thread::sleep_for(5ms);
    }
    for (; next < open.size(); ++next) note(open[next], RunState::missing, "not started");
    return std::move(m_outcome);
  }

private:
  bool stopping() const { return m_outcome.signal != 0 || m_outcome.cannot_write; }

  void note(std::size_t run, RunState status, std::string reason) {
    m_outcome.troubles.push_back({run, status, std::move(reason)});
  }

  /// The runs that are to be computed.
  std::vector<std::size_t> sorted_out(const std::vector<std::size_t>& runs) {
    std::vector<std::size_t> open;
    for (const std::size_t i : runs) {
      const Standing s = standing(m_study.folder, m_study.runs[i]);
      if (s.done()) {
        ++m_outcome.done_before;
        std::error_code ignored; // a log that a pool left when it was killed
        std::filesystem::remove(run_log(m_study.folder, m_study.runs[i]), ignored);
      } else if (s.failed_for_good() && !m_options.retry_failed)
        note(i, s.status, s.reason);
      else
        open.push_back(i);
    }
    return open;
  }

  /// Of each process: more than one where there are fewer runs than jobs, as far as that pays.
  int threads_of_each(std::size_t open) const {
    const auto shared = static_cast<int>(static_cast<std::size_t>(std::max(1, m_options.jobs)) / open);
    return std::max(m_options.threads,
                    std::min(shared, run::threads_that_pay(run::particle_count(m_study.study.base))));
  }

  void start(std::size_t i) {
    const Run& run = m_study.runs[i];
    const Log log(run_log(m_study.folder, run));
    if (!log.mine()) return note(i, RunState::running, "is being computed by another process");
    m_running.push_back({i, Child(run_command(m_study, run, m_threads), log.descriptor())});
  }

  void see_end(const Running& running, int code) {
    const Run& run = m_study.runs[running.run];
    const std::filesystem::path log = run_log(m_study.folder, run);
    const Standing s = standing(m_study.folder, run);
    if (code == exit_code(RunEnd::completed) && s.done()) {
      ++m_outcome.done_now;
      std::filesystem::remove(log);
      return;
    }
    const std::string said = std::filesystem::exists(log) ? read_file(log, largest_log) : std::string();
    ++m_failed_now;
    const bool interrupted = code == exit_code(RunEnd::stopped_by_user);
    const bool by_signal = interrupted || code == exit_code(RunEnd::told_to_terminate);
    const bool unwritten = code == exit_code(RunEnd::cannot_write);
    const bool broken = unwritten && run::has_only_broken_checkpoints(run_folder(m_study.folder, run));
    if (unwritten && !broken) m_outcome.cannot_write = true;
    if (by_signal && !stopping()) m_outcome.ended_by_signal = true;
    std::string reason = broken ? std::string() : s.reason;
    if (code > 128 && !interrupted)
      reason = fmt::format("ended by signal {}{}", code - 128, code == 128 + SIGKILL ? "; too little memory?" : "");
    if (reason.empty())
      reason = said.empty() ? fmt::format("ended with exit code {}", code) : said.substr(0, said.find('\n'));
    note(running.run, by_signal ? RunState::interrupted : RunState::failed, std::move(reason));
  }

  const StudyFolder& m_study;
  PoolOptions m_options;
  const PoolWatch& m_watch;
  PoolOutcome m_outcome;
  std::size_t m_failed_now = 0;
  int m_threads = 1;
  std::list<Running> m_running;
};

} // namespace

PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const PoolOptions& options,
                    const PoolWatch& watch) {
  return Pool(study, options, watch).compute(runs);
}

} // namespace matrigrate::study
