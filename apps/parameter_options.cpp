#include "apps/parameter_options.hpp"

#include "apps/verbs.hpp"
#include "parameters/schema.hpp"
#include "parameters/units.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace matrigrate::apps {

namespace {

constexpr const char* duration = "run.duration";
constexpr const char* seed = "run.seed";
constexpr const char* threads = "run.threads";

/// "6" is "6 h"; a text with a unit stays.
std::string with_hours(const std::string& text) {
  try {
    return units::parse_quantity(text).unit.empty() ? text + " h" : text;
  } catch (const std::invalid_argument&) { // the reader of parameters says what is wrong
    return text;
  }
}

} // namespace

void add_threads(CLI::App& verb, ParameterOptions& options, const std::string& meaning) {
  const Range& range = find_row(threads)->range;
  verb.add_option("--threads", options.threads, meaning)
      ->check(CLI::Range(static_cast<int>(range.low), static_cast<int>(range.high)));
}

std::vector<std::string> all_overrides(const ParameterOptions& options) {
  std::vector<std::string> all = options.overrides;
  if (options.hours) all.push_back(fmt::format("{}={}", duration, with_hours(*options.hours)));
  if (options.seed) all.push_back(fmt::format("{}={}", seed, *options.seed));
  if (options.threads) all.push_back(fmt::format("{}={}", threads, *options.threads));
  return all;
}

ConfigurationError naming_options(const ConfigurationError& error, const ParameterOptions& options) {
  std::vector<Fault> faults = error.faults();
  const auto name = [&](const std::string& key, bool given, const char* option) {
    const auto is_set = [&](const std::string& text) { return text.starts_with(key); };
    if (!given || std::ranges::any_of(options.overrides, is_set)) return;
    for (Fault& fault : faults)
      if (fault.file == "--set" && fault.key == key) fault.file = option;
  };
  name(duration, options.hours.has_value(), "--hours");
  name(seed, options.seed.has_value(), "--seed");
  name(threads, options.threads.has_value(), "--threads");
  return ConfigurationError(std::move(faults));
}

std::string tag_of(std::string_view change) {
  const std::size_t equals = change.find('=');
  const std::string_view key = change.substr(0, equals);
  if (equals == std::string_view::npos || key == seed || key == threads) return {};
  const auto kept = [](unsigned char c) { return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-'; };
  std::string tag = "-" + std::string(key.substr(key.rfind('.') + 1)) + "-";
  std::ranges::copy_if(change.substr(equals + 1), std::back_inserter(tag), kept);
  return tag;
}

double seconds_of(const std::string& text) {
  try {
    const units::Quantity quantity = units::parse_quantity(text);
    const units::Unit unit = units::parse_unit(quantity.unit.empty() ? "s" : quantity.unit);
    const double seconds = units::to_internal(quantity.number, unit);
    if (unit.dimension == units::Dimension{.time = 1000} && seconds > 0.0) return seconds;
  } catch (const std::invalid_argument&) { // said below
  }
  throw UsageError(fmt::format("\"{}\" is not a time; write it like \"90 s\" or \"2 h\"", text));
}

} // namespace matrigrate::apps
