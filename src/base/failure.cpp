#include "base/failure.hpp"

#include <fmt/format.h>

#include <utility>

namespace matrigrate {

namespace {

std::string joined(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

} // namespace

std::string to_string(const Fault& fault) {
  std::string place = fault.file;
  if (fault.line > 0) place += fmt::format(":{}", fault.line);
  if (fault.line > 0 && fault.column > 0) place += fmt::format(":{}", fault.column);
  if (!fault.key.empty()) place += (place.empty() ? "" : ": ") + fault.key;
  return place.empty() ? fault.message : place + ": " + fault.message;
}

std::string_view to_string(FailureCause cause) {
  switch (cause) {
  case FailureCause::solver:
    return "solver";
  case FailureCause::step_limit:
    return "step_limit";
  case FailureCause::rim:
    return "rim";
  case FailureCause::crossing:
    return "crossing";
  case FailureCause::nucleus_outside:
    return "nucleus_outside";
  case FailureCause::collapse:
    return "collapse";
  case FailureCause::solid_inside:
    return "solid_inside";
  case FailureCause::not_finite:
    return "not_finite";
  case FailureCause::law:
    return "law";
  default:
    return "imbalance";
  }
}

std::optional<FailureCause> parse_failure_cause(std::string_view text) {
  using enum FailureCause;
  for (const FailureCause cause :
       {solver, step_limit, rim, crossing, nucleus_outside, collapse, solid_inside, not_finite, law, imbalance})
    if (text == to_string(cause)) return cause;
  return std::nullopt;
}

ConfigurationError::ConfigurationError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), m_faults(std::move(faults)) {}

} // namespace matrigrate
