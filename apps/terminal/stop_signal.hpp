#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace matrigrate::apps {

/// While it lives, the first SIGINT, SIGTERM, SIGUSR1 (which Slurm sends ahead of a time limit) or SIGHUP is noted
/// instead of ending the program, and a second one ends it at once, if it comes more than a second later: `timeout`,
/// batch systems and Child tell a process both by itself and with its group, which is one wish. A SIGHUP that is
/// ignored stays so (`nohup`). One StopSignal at a time.
class StopSignal {
public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  /// The signal that has come, or 0.
  static int received();

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGUSR1, SIGHUP};
  std::array<struct sigaction, signals.size()> m_old{};
};

} // namespace matrigrate::apps
