#pragma once

#include <array>
#include <csignal>
#include <cstddef>

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

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGUSR1, SIGHUP};
  std::array<struct sigaction, signals.size()> m_old{};
};

} // namespace matrigrate::apps
