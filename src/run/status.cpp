#include "run/status.hpp"

namespace matrigrate::run {

std::string_view to_string(RunStatus status) {
  switch (status) {
  case RunStatus::running:
    return "running";
  case RunStatus::done:
    return "done";
  case RunStatus::failed:
    return "failed";
  default:
    return "interrupted";
  }
}

std::optional<RunStatus> parse_run_status(std::string_view text) {
  for (const RunStatus status : {RunStatus::running, RunStatus::done, RunStatus::failed, RunStatus::interrupted})
    if (text == to_string(status)) return status;
  return std::nullopt;
}

} // namespace matrigrate::run
