#include "base/process.hpp"

#include "base/failure.hpp"
#include "base/platform.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace matrigrate {

namespace {

/// What happens between fork and exec; only calls that a signal handler may make.
[[noreturn]] void become(char* const* arguments, int output, pid_t parent, const sigset_t& blocked) {
  platform::end_with_parent();
  if (::getppid() != parent) ::_exit(128 + SIGTERM); // it ended before the line above
  for (int signal = 1; signal < 32; ++signal) { // what comes from here on is for the command, not for handlers of here
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action.sa_handler = SIG_DFL;
    action.sa_flags = 0;
    ::sigaction(signal, &action, nullptr);
  }
  ::pthread_sigmask(SIG_SETMASK, &blocked, nullptr);
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execvp(arguments[0], arguments);
  ::_exit(no_such_program);
}

} // namespace

Child::Child(std::vector<std::string> command, int output) : m_id(-1), m_since(std::chrono::steady_clock::now()) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  sigset_t every;
  sigset_t before;
  ::sigfillset(&every);
  ::pthread_sigmask(SIG_SETMASK, &every, &before);
  m_id = ::fork();
  if (m_id == 0) become(arguments.data(), output, parent, before);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (m_id < 0)
    throw InputOutputError(
        fmt::format("{}: no process can be made: {}", command.front(), std::generic_category().message(errno)));
}

std::optional<int> Child::ended() {
  if (m_ended) return m_ended;
  int status = 0;
  const pid_t found = ::waitpid(m_id, &status, WNOHANG);
  if (found == m_id) m_ended = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return m_ended;
}

void Child::pass_on(int signal) {
  if (m_told || m_ended || !platform::catches(m_id, signal, std::chrono::steady_clock::now() - m_since)) return;
  m_told = platform::pass_on(m_id, signal);
}

} // namespace matrigrate
