#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace matrigrate {

/// A command that is run beside this program. It is asked to terminate when this program ends, however that happens,
/// where the system can do that (platform.hpp); files that are open here without O_CLOEXEC stay open in it.
class Child {
public:
  /// @param command  program, looked for in PATH if it has no slash, and arguments
  /// @param output   descriptor that its standard output and error go to
  /// @throws InputOutputError if no process can be made
  Child(std::vector<std::string> command, int output);

  /// How it ended: its exit code, or 128 + the number of the signal that ended it; none while it runs.
  std::optional<int> ended();

  /// Passes on a signal to stop, once, and only when the command catches it: before, it is only starting. Does nothing
  /// to a command that has received one by another way already (StopSignal). To be called again until it ends.
  void pass_on(int signal);

private:
  pid_t m_id;
  std::chrono::steady_clock::time_point m_since;
  bool m_told = false;
  std::optional<int> m_ended;
};

/// Exit code of a Child whose program is not there.
inline constexpr int no_such_program = 127;

} // namespace matrigrate
