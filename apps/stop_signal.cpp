#include "apps/stop_signal.hpp"

namespace matrigrate::apps {

namespace {

/// The one thing that a signal handler may write to.
volatile std::sig_atomic_t& note() {
  static volatile std::sig_atomic_t number = 0;
  return number;
}

void handle(int number) { note() = number; }

} // namespace

StopSignal::StopSignal() {
  note() = 0;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    struct sigaction action {};
    action.sa_handler = handle;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signals[k], &action, &m_old[k]);
  }
}

StopSignal::~StopSignal() {
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &m_old[k], nullptr);
}

int StopSignal::received() { return note(); }

} // namespace matrigrate::apps
