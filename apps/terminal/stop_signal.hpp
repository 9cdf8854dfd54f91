#pragma once

#include <array>
#include <csignal>
#include <optional>
#include <string_view>

namespace matrigrate::apps {

/// While an object lives, the first SIGINT, SIGTERM, SIGUSR1 (which Slurm sends ahead of a time limit) or SIGHUP is
/// noted instead of ending the program. A second signal more than a second later ends it at once. `timeout`, batch
/// systems and Child signal both the process and its group, so two signals within a second count as one request. A
/// SIGHUP that is ignored stays so (`nohup`). One StopSignal at a time.
class StopSignal {
public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  /// The signal that has come, or 0.
  static int received();

  /// From now on to first_step() nothing is computed that could be saved, and who builds a large matrix does not ask
  /// received() for minutes: the program is ended `grace` seconds after a signal, or after the limit, with the exit
  /// code of a run that was stopped.
  /// @param limit  of wall time [s]
  static void before_first_step(std::optional<double> limit);
  static void first_step();

  static constexpr unsigned grace = 3; ///< [s]

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGUSR1, SIGHUP};
  std::array<struct sigaction, signals.size()> m_old{};
  struct sigaction m_old_alarm {};
};

/// Writes to the standard error as a signal handler may, and where there is no memory.
void say(std::string_view text);

/// From here on a sudden end of the program gives exit code 4 and one line on standard error. Sudden ends are the
/// signals of a fault of the program or a library (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT), and a library that calls
/// exit() with a code that the program does not use. A cause is the end of memory, for which not every library is
/// prepared. No file is touched: files are replaced at once, so they are whole, and a run can be resumed from its last
/// checkpoint as after SIGKILL. A stack overflow is caught in the thread that calls this function; in other threads it
/// ends the program by its signal.
///
/// Does nothing where the signal itself is wanted, with its core: if MATRIGRATE_CORE_DUMP is in the environment, or if
/// someone else handles SIGSEGV already, as sanitizers do. Debuggers see the signal first. Test:
/// tests/apps/sudden_end_test.cpp
void give_sudden_ends_an_exit_code();

} // namespace matrigrate::apps
