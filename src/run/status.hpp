#pragma once

#include <optional>
#include <string_view>

/// How a run stands, and how one ended. Test:
/// tests/unit/run/run_test.cpp
namespace matrigrate::run {

/// What "status" in run.json says.
enum class RunStatus { running, done, failed, interrupted };

/// "running", "done", "failed", "interrupted"
std::string_view to_string(RunStatus status);

/// The status of that name; nothing for other text.
std::optional<RunStatus> parse_run_status(std::string_view text);

/// How the computation of a run ended.
enum class RunEnd {
  completed,
  numerical_failure,
  no_memory,
  cannot_write,      ///< one of its files
  stopped_by_user,   ///< Ctrl-C
  told_to_terminate, ///< by another signal
  out_of_wall_time   ///< RunOptions::wall_time_limit
};

constexpr RunStatus status_of(RunEnd end) {
  switch (end) {
  case RunEnd::completed:
    return RunStatus::done;
  case RunEnd::stopped_by_user:
  case RunEnd::told_to_terminate:
  case RunEnd::out_of_wall_time:
    return RunStatus::interrupted;
  default:
    return RunStatus::failed;
  }
}

/// What "exit_code" in run.json says, with which the program ends too.
constexpr int exit_code(RunEnd end) {
  switch (end) {
  case RunEnd::completed:
    return 0;
  case RunEnd::cannot_write:
    return 5;
  case RunEnd::stopped_by_user:
    return 130;
  case RunEnd::told_to_terminate:
  case RunEnd::out_of_wall_time:
    return 75;
  default:
    return 4;
  }
}

} // namespace matrigrate::run
