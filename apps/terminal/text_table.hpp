#pragma once

#include "statistics/compare.hpp"

#include <string>
#include <vector>

/// Tables of numbers for people, on the terminal. Test: tests/apps/study_test.cpp
namespace matrigrate::apps {

/// "1.23", or "-" where it is not defined.
std::string number_text(double value);

/// "1.2 to 3.4", or "-".
std::string interval_text(const statistics::Interval& i);

/// Columns as wide as they have to be: words to the left, numbers to the right.
/// @param words  how many columns, from the first on, hold words
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t words);

} // namespace matrigrate::apps
