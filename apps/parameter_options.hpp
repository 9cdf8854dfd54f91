#pragma once

#include "base/failure.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

/// Options of the command line that set parameters. Test: tests/apps/run_test.cpp
namespace matrigrate::apps {

struct ParameterOptions {
  std::vector<std::string> overrides; ///< --set: "key=value"
  std::optional<std::string> hours;   ///< a number, or a time with its unit: "30 min"
  std::optional<std::string> seed;
  std::optional<int> threads;
};

/// Adds --threads with its range.
void add_threads(CLI::App& verb, ParameterOptions& options, const std::string& meaning);

/// All options as "key=value", the changes by --set first.
std::vector<std::string> all_overrides(const ParameterOptions& options);

/// The faults of an error, naming the option that was given: "--hours" where run.duration was not given by --set.
ConfigurationError naming_options(const ConfigurationError& error, const ParameterOptions& options);

/// What a change by --set adds to the name of a folder: "-youngs_modulus-50Pa" of "ecm.youngs_modulus=50 Pa"; nothing
/// of run.seed and run.threads.
std::string tag_of(std::string_view change);

/// Parses "90 s", "2 h", ... @return seconds, above 0 @throws UsageError
double seconds_of(const std::string& text);

} // namespace matrigrate::apps
