#pragma once

#include <csignal>

namespace matrigrate::apps {

/// While it lives, the first SIGINT or SIGTERM is noted instead of ending the program; a second one ends it at once.
/// One at a time.
class StopSignal {
public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  /// SIGINT, SIGTERM, or 0 if none has come.
  static int received();

private:
  struct sigaction m_old_interrupt {};
  struct sigaction m_old_terminate {};
};

} // namespace matrigrate::apps
