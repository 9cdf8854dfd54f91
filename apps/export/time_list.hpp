#pragma once

#include <string>
#include <vector>

namespace matrigrate::apps {

/// The parts of a list between commas, without the spaces around them.
std::vector<std::string> items_of(const std::string& list);

/// A time: "1 h 30 min"; a number without a unit is hours [s].
/// @throws std::invalid_argument saying what is wrong
double time_of(const std::string& text);

} // namespace matrigrate::apps
