#include "apps/terminal/stop_signal.hpp"

#include "apps/verbs.hpp"
#include "base/platform.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <utility>

namespace matrigrate::apps {

namespace {

/// Variables of a type that a signal handler may write.
struct Note {
  std::atomic<int> number;         // of the signal that came first
  std::atomic<std::int64_t> since; // ms; when it came
  std::atomic<bool> building;      // nothing is computed yet
  static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);
};

Note& note() {
  static constinit Note the_note{0, 0, false};
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
    if (note().building) ::alarm(StopSignal::grace);
  } else if (info->si_code != SI_QUEUE && ms - note().since > 1000) { // Child queues what it passes on
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    ::sigaction(number, &action, nullptr);
    ::raise(number); // waits until this returns
  }
}

/// The same. Time is up before the first step.
void end_before_first_step(int /*number*/) {
  if (!note().building) return;
  say("matrigrate: stopped before the first step: nothing was computed since the start, and nothing is lost. The same "
      "command starts again.\n");
  ::_exit(note().number == SIGINT ? interrupted : requeue);
}

} // namespace

void say(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

StopSignal::StopSignal() {
  note().number = 0;
  struct sigaction alarm {};
  alarm.sa_handler = end_before_first_step;
  ::sigfillset(&alarm.sa_mask);
  ::sigaction(SIGALRM, &alarm, &m_old_alarm);
  for (std::size_t k = 0; k < signals.size(); ++k) {
    struct sigaction action {};
    action.sa_sigaction = handle;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    ::sigfillset(&action.sa_mask); // one at a time
    ::sigaction(signals[k], &action, &m_old[k]);
    if (signals[k] == SIGHUP && m_old[k].sa_handler == SIG_IGN) ::sigaction(SIGHUP, &m_old[k], nullptr);
  }
}

void StopSignal::before_first_step(std::optional<double> limit) {
  constexpr double longest = 1e8; // [s]
  note().building = true;
  if (limit) ::alarm(static_cast<unsigned>(std::ceil(std::min(*limit, longest))) + grace);
}

void StopSignal::first_step() {
  if (note().building.exchange(false)) ::alarm(0);
}

StopSignal::~StopSignal() {
  first_step();
  ::sigaction(SIGALRM, &m_old_alarm, nullptr);
  for (std::size_t k = 0; k < signals.size(); ++k) ::sigaction(signals[k], &m_old[k], nullptr);
}

int StopSignal::received() { return note().number; }

namespace {

constexpr std::array<std::pair<int, std::string_view>, 5> signals{
    {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"}, {SIGFPE, "SIGFPE"}, {SIGILL, "SIGILL"}, {SIGABRT, "SIGABRT"}}};
constexpr std::array<int, 8> codes{done, internal, usage, configuration, numerical, input_output, requeue, interrupted};

/// True once a signal has come; of a type that a signal handler may write.
std::atomic_flag& come() {
  static constinit std::atomic_flag the_flag;
  return the_flag;
}

/// Only calls that a signal handler may make.
[[noreturn]] void end_at_once(std::string_view cause) {
  say("matrigrate: ended by ");
  say(cause);
  say(": the program or a library has a fault, or memory ran out. The last checkpoint and the files up to it are good; "
      "matrigrate resume continues from there. If this happens again, please report it with what info prints.\n");
  ::_exit(numerical);
}

/// A second fault in here ends the program by its signal, which is blocked.
[[noreturn]] void handle(int signal) {
  while (come().test_and_set()) ::pause(); // another thread is at it
  end_at_once(std::ranges::find(signals, signal, &std::pair<int, std::string_view>::first)->second);
}

/// @param code  that exit() was called with, or main() returned
void see_code(int code, void* /*nothing*/) {
  if (std::ranges::find(codes, code) == codes.end()) end_at_once("a library that called exit()");
}

} // namespace

void give_sudden_ends_an_exit_code() {
  static std::array<std::byte, 1U << 16U> stack; // for a handler where the usual stack is used up
  struct sigaction before {};
  if (std::getenv("MATRIGRATE_CORE_DUMP") != nullptr) return;
  if (::sigaction(SIGSEGV, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) return;
  stack_t other{};
  other.ss_sp = stack.data();
  other.ss_size = stack.size();
  ::sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_ONSTACK;
  ::sigfillset(&action.sa_mask);
  for (const auto& [signal, name] : signals) ::sigaction(signal, &action, nullptr);
  platform::at_exit(see_code);
}

} // namespace matrigrate::apps
