#pragma once

#include "parameters/presets.hpp"
#include "run/status.hpp"

#include <functional>
#include <stdexcept>
#include <string>

/// What the verbs of the program share. Each is a file with a function that adds it to the command line; when it is
/// given, it sets what is to be done. Verbs, exit codes and exceptions are brought together in main.cpp and nowhere
/// else.
namespace matrigrate::apps {

using namespace run;

/// Exit codes of the program. run.json records the exit code of a run too (run/status.hpp).
enum ExitCode : int {
  done = 0,
  internal = 1,
  usage = 2,
  configuration = 3,
  numerical = 4,
  input_output = 5,
  requeue = 75,     ///< stopped by a signal to terminate
  interrupted = 130 ///< stopped by Ctrl-C
};
static_assert(run::exit_code(RunEnd::completed) == done && run::exit_code(RunEnd::numerical_failure) == numerical
              && run::exit_code(RunEnd::no_memory) == numerical && run::exit_code(RunEnd::cannot_write) == input_output
              && run::exit_code(RunEnd::told_to_terminate) == requeue
              && run::exit_code(RunEnd::stopped_by_user) == interrupted);

/// The command line asks for something that does not exist. Exit code 2.
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// @throws UsageError, with all names, if there is no preset of that name
const Preset& preset_named(const std::string& name);

/// What the chosen verb does. @return the exit code
using Action = std::function<int()>;

} // namespace matrigrate::apps
