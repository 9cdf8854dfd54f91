#include "apps/study/verbs.hpp"

#include "apps/terminal/progress.hpp"
#include "apps/terminal/stop_signal.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace matrigrate::apps {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

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

} // namespace

PoolOutcome compute(const StudyFolder& study, const std::vector<std::size_t>& runs, const study::PoolOptions& options,
                    bool quiet) {
  std::optional<StopSignal> signals;
  std::optional<PoolProgress> progress;
  return study::compute(study, runs, options, [&](std::size_t all, std::size_t ended, std::size_t failed) {
    if (!progress) {
      signals.emplace();
      progress.emplace(all, options.jobs, quiet);
    }
    progress->show(ended, failed);
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

} // namespace matrigrate::apps
