#include "apps/terminal/stop_signal.hpp"

#include <atomic>
#include <cstdint>
#include <ctime>

namespace matrigrate::apps {

namespace {

/// Variables of a type that a signal handler may write.
struct Note {
  std::atomic<int> number;         // of the signal that came first
  std::atomic<std::int64_t> since; // ms; when it came
  static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);
};

Note& note() {
  static constinit Note the_note{0, 0};
  return the_note;
}

/// Only calls that a signal handler may make.
void handle(int number, siginfo_t* info, void* /*context*/) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t ms = std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1000000;
  if (note().number == 0) {
    note().since = ms;
    note().number = number;
  } else if (info->si_code != SI_QUEUE && ms - note().since > 1000) { // Child queues what it passes on
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    ::sigaction(number, &action, nullptr);
    ::raise(number); // waits until this returns
  }
}

} // namespace

StopSignal::StopSignal() {
  note().number = 0;
  for (std::size_t k = 0; k < signals.size(); ++k) {
    struct sigaction action {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    ::sigfillset(&action.sa_mask); // one at a time
    ::sigaction(signals[k], &action, &m_old[k]);
    if (signals[k] == SIGHUP && m_old[k].sa_handler == SIG_IGN) ::sigaction(SIGHUP, &m_old[k], nullptr);
  }
}

StopSignal::~StopSignal() {
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &m_old[k], nullptr);
}

int StopSignal::received() { return note().number; }

} // namespace matrigrate::apps
