#pragma once

#include "base/failure.hpp"
#include "statistics/compare.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::apps {

// Text on the screen. Colour only on a terminal, and not where NO_COLOR is set (https://no-color.org).

enum class Stream { out, err };
enum class Colour { bad, good, warning, strong };

/// text in a colour, if the stream shows colours
std::string coloured(std::string_view text, Colour colour, Stream stream);

/// @throws InputOutputError if the stream cannot be written
void print(std::string_view text);
void flush();

/// On lines of their own; what is no UTF-8 in it is replaced.
void print_json(const nlohmann::ordered_json& json);

void print_error(std::string_view text);
void print_warning(std::string_view text); ///< a line, after the program's name
void print_failure(std::string_view text); ///< the same in another colour
void print_faults(const std::vector<Fault>& faults);

// Tables of numbers for people, on the terminal. Test: tests/apps/study_test.cpp

/// "1.23", or "-" where it is not defined.
std::string number_text(double value);

/// "1.2 to 3.4", or "-".
std::string interval_text(const statistics::Interval& i);

/// Columns as wide as they have to be: words to the left, numbers to the right.
/// @param words  how many columns, from the first on, hold words
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t words);

} // namespace matrigrate::apps
