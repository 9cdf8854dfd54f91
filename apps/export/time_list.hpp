#pragma once

#include <string>
#include <vector>

namespace matrigrate::apps {

/// The parts of a list between commas, without the spaces around them; none of an empty text.
std::vector<std::string> items_of(const std::string& list);

/// A time with its unit, "1 h 30 min"; 0 needs none [s].
/// @throws std::invalid_argument saying what is wrong
double time_of(const std::string& text);

} // namespace matrigrate::apps
