#pragma once

#include "parameters/read.hpp"

#include <string>
#include <vector>

namespace matrigrate {

/// The faults of a text called "f.toml", as they are printed; none if it is good.
inline std::vector<std::string> faults_of(std::string_view text, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> printed;
  try {
    parse_parameters(text, "f.toml", overrides);
  } catch (const ConfigurationError& error) {
    for (const Fault& fault : error.faults()) printed.push_back(to_string(fault));
  }
  return printed;
}

/// The only fault of a text; otherwise how many there are.
inline std::string fault_of(std::string_view text, const std::vector<std::string>& overrides = {}) {
  const auto faults = faults_of(text, overrides);
  if (faults.size() == 1) return faults.front();
  std::string all = std::to_string(faults.size()) + " faults";
  for (const std::string& fault : faults) all += "\n  " + fault;
  return all;
}

} // namespace matrigrate
