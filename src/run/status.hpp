#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

/// How a run stands, and how one ended. Test:
/// tests/unit/run/run_test.cpp
namespace matrigrate::run {

/// What "status" in run.json says.
enum class RunStatus { running, done, failed, interrupted };

inline constexpr std::array<std::string_view, 4> status_names{"running", "done", "failed", "interrupted"};

constexpr std::string_view to_string(RunStatus status) { return status_names[static_cast<std::size_t>(status)]; }

/// The status of that name; nothing for other text.
constexpr std::optional<RunStatus> parse_run_status(std::string_view text) {
  const auto* const found = std::ranges::find(status_names, text);
  if (found == status_names.end()) return std::nullopt;
  return static_cast<RunStatus>(found - status_names.begin());
}

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
  if (end == RunEnd::completed) return RunStatus::done;
  return end < RunEnd::stopped_by_user ? RunStatus::failed : RunStatus::interrupted;
}

/// What "exit_code" in run.json says, with which the program ends too.
constexpr int exit_code(RunEnd end) {
  constexpr std::array codes{0, 4, 4, 5, 130, 75, 75};
  return codes[static_cast<std::size_t>(end)];
}

} // namespace matrigrate::run
