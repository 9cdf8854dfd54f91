#include "apps/child.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace matrigrate::apps {

namespace {

/// What happens between fork and exec; only calls that a signal handler may make.
[[noreturn]] void become(char* const* arguments, int output, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(128 + SIGTERM); // it ended before the line above
  const int input = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execvp(arguments[0], arguments);
  ::_exit(no_such_program);
}

/// Whether a process catches a signal and none of it is under way: from /proc, where it can be read.
bool listens(pid_t id, int signal) {
  std::ifstream status(fmt::format("/proc/{}/status", id));
  const unsigned long long bit = 1ULL << (signal - 1);
  bool caught = false;
  for (std::string line; std::getline(status, line);) {
    const auto mask = [&] { return std::stoull(line.substr(line.find(':') + 1), nullptr, 16); };
    if ((line.starts_with("SigPnd:") || line.starts_with("ShdPnd:")) && (mask() & bit) != 0) return false;
    if (line.starts_with("SigCgt:")) caught = (mask() & bit) != 0;
  }
  return caught;
}

} // namespace

std::string this_program() { return "/proc/self/exe"; }

Child::Child(std::vector<std::string> command, int output) : m_id(-1) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  m_id = ::fork();
  if (m_id == 0) become(arguments.data(), output, parent);
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
  if (m_told || m_ended || !listens(m_id, signal)) return;
  m_told = ::kill(m_id, signal) == 0;
}

} // namespace matrigrate::apps
