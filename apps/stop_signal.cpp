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
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(SIGINT, &action, &m_old_interrupt);
  ::sigaction(SIGTERM, &action, &m_old_terminate);
}

StopSignal::~StopSignal() {
  ::sigaction(SIGINT, &m_old_interrupt, nullptr);
  ::sigaction(SIGTERM, &m_old_terminate, nullptr);
}

int StopSignal::received() { return note(); }

} // namespace matrigrate::apps
