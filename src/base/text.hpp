#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace matrigrate {

/// Text as a field of CSV: in quotes where it holds a character that would end the field, and after an apostrophe where
/// a spreadsheet would compute it as a formula, that is, where it begins with = + - @, a tab or a line break and is no
/// number. Test: tests/unit/tables/tables_test.cpp
std::string csv_text(std::string_view field);

/// The whole of a text as a number: no blanks, no +, a decimal point. Nothing if it is none.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Bytes of the UTF-8 character that starts a text that is not empty; 0 if it is none.
std::size_t character_length(std::string_view text);

// Human-readable durations. Test: tests/unit/base/base_test.cpp

/// A simulated time: "0 s", "45 min", "2 h 30 min".
/// @param seconds  >= 0
std::string time_text(double seconds);

/// A wall-clock duration: "45 s", "12 min", "3.2 h".
std::string wall_time_text(double seconds);

} // namespace matrigrate
