#pragma once

#include "parameters/parameters.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <string>
#include <vector>

/// Two runs or two scenarios, compared. Test: tests/apps/open_test.cpp
namespace matrigrate::run {

/// {a, b, parameters: [[path, a, b]]} and, of two runs, {same_trajectory, first_difference_s, runs: {key: [a, b]},
/// readouts: [[name, a, b]]}. What a side does not have is null.
/// @param a, b  each the folder of a run or a scenario file
/// @throws InputOutputError, ConfigurationError if one of them cannot be read
nlohmann::ordered_json difference(const std::string& a, const std::string& b);

/// [path, value of a, value of b] of the parameters that differ.
std::vector<std::array<std::string, 3>> parameters_that_differ(const Parameters& a, const Parameters& b);

} // namespace matrigrate::run
