#pragma once

#include "apps/terminal/progress.hpp"
#include "apps/terminal/stop_signal.hpp"
#include "run/finished_run.hpp"
#include "run/simulate.hpp"

#include <optional>

/// A run on the terminal. Test: tests/apps/run_test.cpp, tests/apps/progress_test.cpp
namespace matrigrate::apps {

/// Shows progress and warnings on the standard error; signals to this program stop the run.
class RunDisplay : public run::RunObserver {
public:
  /// @param quiet  show no progress
  explicit RunDisplay(bool quiet) : m_quiet(quiet) {}

  /// Before the run begins: signals and the limit of wall time may end the program while the matrix is built, without
  /// an outcome (StopSignal::before_first_step).
  void may_end_before_first_step(double wall_time_limit) { m_limit = wall_time_limit; }

  void warn(std::string_view text) override;
  void begin() override;
  void begin_steps(double t, double t_end) override;
  void end_steps() override { m_progress.reset(); }
  void step(const State& s) override;
  std::optional<run::StopRequest> stop_request() override;

private:
  bool m_quiet;
  std::optional<StopSignal> m_signal; ///< before there is a folder, and until the outcome is printed
  std::optional<Progress> m_progress;
  double m_begin = 0.0;          ///< where this process begins: the time left is estimated from what it does itself [s]
  double m_end = 0.0;            ///< of the whole run [s]
  std::optional<double> m_limit; ///< of wall time; none: the program is not ended so [s]
};

/// What a run prints at its end.
struct OutcomeStyle {
  bool json = false;
  bool quiet = false;
};

/// How a run ended, its read-outs and where the report is. @return the exit code
int print_outcome(const run::RunOutcome& outcome, const OutcomeStyle& style);

/// Warns of frames of a run that are lost, if there are any.
void tell_lost_frames(const run::FinishedRun& run);

} // namespace matrigrate::apps
