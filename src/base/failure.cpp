#include "base/failure.hpp"

#include <fmt/format.h>

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

ConfigurationError::ConfigurationError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), m_faults(std::move(faults)) {}

} // namespace matrigrate
