#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// "Did you mean": the name that somebody most likely meant to type. Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

/// Least number of characters inserted, removed, replaced or swapped with their neighbour that turns a into b;
/// upper and lower case count as the same.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// @return the name nearest to `typed`, if it is near enough to be a slip of the fingers
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string>& names);

/// The same, or the first name that goes on where `typed` ends, or the read-out that a word such as "speed" stands for.
std::optional<std::string> nearest_readout(std::string_view typed, const std::vector<std::string>& names);

/// The parameter or section that somebody most likely meant: near in spelling, the same key in another section, or the
/// paper's symbol of it ("E").
std::optional<std::string> nearest_parameter(std::string_view path);

/// "; did you mean X?", or nothing.
std::string did_you_mean(const std::optional<std::string>& name);

/// What to say of a parameter that does not exist: which one was most likely meant, or that it is a result; or nothing.
std::string parameter_hint(std::string_view path);

} // namespace matrigrate
