#pragma once

#include "parameters/parameters.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What parameters must fulfil together. Test: tests/unit/parameters/schema_test.cpp, read_test.cpp
namespace matrigrate {

/// A condition on several parameters.
struct Rule {
  std::string_view name;
  /// All parameters that it depends on; the first one set on the command line, else in the file, is blamed.
  std::vector<std::string_view> keys;
  std::function<std::string(const Parameters&)>
      broken; ///< what is wrong and what is allowed; empty where the rule holds
};

std::span<const Rule> rules();

} // namespace matrigrate
