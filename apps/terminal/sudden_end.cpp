#include "apps/terminal/sudden_end.hpp"

#include "apps/verbs.hpp"
#include "base/platform.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace matrigrate::apps {

namespace {

constexpr std::array signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
constexpr std::array<int, 8> codes{done, internal, usage, configuration, numerical, input_output, requeue, interrupted};

/// True once a signal has come; of a type that a signal handler may write.
std::atomic_flag& come() {
  static constinit std::atomic_flag the_flag;
  return the_flag;
}

std::string_view name_of(int signal) {
  switch (signal) {
  case SIGSEGV:
    return "SIGSEGV";
  case SIGBUS:
    return "SIGBUS";
  case SIGFPE:
    return "SIGFPE";
  case SIGILL:
    return "SIGILL";
  default:
    return "SIGABRT";
  }
}

void say(std::string_view text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
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
  end_at_once(name_of(signal));
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
  for (const int signal : signals) ::sigaction(signal, &action, nullptr);
  platform::at_exit(see_code);
}

} // namespace matrigrate::apps
