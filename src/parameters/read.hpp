#pragma once

#include "base/failure.hpp"
#include "parameters/parameters.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// From a scenario file to parameters. What a file leaves out has its default. Every fault of the file and of the
/// overrides is reported at once, sorted by line; no fault leaves a half-read result.
/// Test: tests/unit/parameters/read_test.cpp, tests/unit/parameters/hostile_test.cpp
namespace matrigrate {

/// @param overrides  "key=value" each, as after --set; the value in TOML or bare (400 Pa, hexagonal); the last one wins
/// @throws ConfigurationError with all faults, also if the file is binary
/// @throws InputOutputError if the file is missing, a folder, or over 1 MiB
Parameters read_parameters(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// @param name  stands for the file in faults
/// @throws ConfigurationError with all faults
Parameters parse_parameters(std::string_view text, const std::string& name,
                            const std::vector<std::string>& overrides = {});

/// @throws ConfigurationError with all faults, those of the file "--set"
Parameters apply_overrides(const Parameters& p, const std::vector<std::string>& overrides);

} // namespace matrigrate
