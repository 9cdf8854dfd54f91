#include "apps/study/pool_output.hpp"

#include "apps/terminal/progress.hpp"
#include "apps/terminal/stop_signal.hpp"
#include "apps/terminal/terminal.hpp"
#include "apps/verbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace matrigrate::apps {

namespace {

/// Progress on the standard error; signals to this program stop the pool.
class PoolDisplay : public study::PoolObserver {
public:
  explicit PoolDisplay(bool quiet) : m_quiet(quiet) {}

  void begin(std::size_t runs, int jobs) override {
    m_total = std::max<std::size_t>(1, runs);
    m_jobs = static_cast<std::size_t>(jobs);
    m_signal.emplace();
    m_progress.emplace(m_quiet);
  }
  void end() override {
    m_progress.reset();
    m_signal.reset();
  }
  void show(std::size_t ended, std::size_t failed) override {
    m_progress->show([&](double elapsed) {
      const auto done = static_cast<double>(ended), total = static_cast<double>(m_total);
      const bool known = ended >= std::min(m_jobs, m_total);
      ProgressText text{.share = done / total,
                        .where = fmt::format("{} of {} runs", ended, m_total),
                        .left = known ? time_left(elapsed, done, total - done)
                                      : std::string("time left is known when the first runs end"),
                        .remark = failed > 0 ? fmt::format("{} not done", failed) : std::string()};
      text.line = fmt::format("{}, {}{}{}", text.where, text.left, failed > 0 ? ", " : "", text.remark);
      return text;
    });
  }
  int stop_signal() override { return StopSignal::received(); }

private:
  bool m_quiet;
  std::optional<StopSignal> m_signal;
  std::optional<Progress> m_progress;
  std::size_t m_total = 1;
  std::size_t m_jobs = 1;
};

} // namespace

study::PoolOutcome compute(const study::StudyFolder& study, const std::vector<std::size_t>& runs,
                           const ShownPoolOptions& options) {
  PoolDisplay display(options.quiet);
  return study::compute(
      study, runs, {.jobs = options.jobs, .threads = options.threads, .retry_failed = options.retry_failed}, display);
}

int exit_code(const study::PoolOutcome& outcome) {
  if (outcome.signal != 0) return outcome.signal == SIGINT ? interrupted : requeue;
  if (outcome.cannot_write) return input_output;
  if (outcome.ended_by_signal) return requeue;
  if (std::ranges::any_of(outcome.troubles, [](const auto& t) { return t.status == study::RunState::damaged; }))
    return input_output;
  const bool failed = std::ranges::any_of(outcome.troubles,
                                          [](const study::Trouble& t) { return t.status != study::RunState::running; });
  return failed ? numerical : done;
}

std::string troubles_text(const study::StudyFolder& study, const std::vector<study::Trouble>& troubles) {
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
