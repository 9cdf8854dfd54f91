#pragma once

#include "run/status.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The verbs of the program, one file each. A verb adds itself to the command line; when it is given, it sets what is
/// to be done. Exit codes and exceptions are brought together in main.cpp and nowhere else.
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

/// What the chosen verb does. @return the exit code
using Action = std::function<int()>;

void add_new(CLI::App& app, Action& chosen);
void add_list(CLI::App& app, Action& chosen);
void add_check(CLI::App& app, Action& chosen);
void add_explain(CLI::App& app, Action& chosen);
void add_run(CLI::App& app, Action& chosen, std::vector<std::string> command_line);
void add_sample(CLI::App& app, Action& chosen, std::vector<std::string> command_line);
void add_resume(CLI::App& app, Action& chosen, std::vector<std::string> command_line);
void add_demo(CLI::App& app, Action& chosen, std::vector<std::string> command_line);
void add_diff(CLI::App& app, Action& chosen);
void add_open(CLI::App& app, Action& chosen);
void add_live(CLI::App& app, Action& chosen);
void add_report(CLI::App& app, Action& chosen);
void add_export(CLI::App& app, Action& chosen);
void add_tracks(CLI::App& app, Action& chosen);
void add_validate(CLI::App& app, Action& chosen);
void add_selftest(CLI::App& app, Action& chosen);
void add_study(CLI::App& app, Action& chosen);
void add_reproduce(CLI::App& app, Action& chosen, const std::vector<std::string>& command_line);
void add_info(CLI::App& app, Action& chosen);

} // namespace matrigrate::apps
