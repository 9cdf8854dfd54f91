#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A text as rows of fields. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

struct SheetRow {
  std::size_t line = 0; ///< where it begins, from 1
  std::vector<std::string> fields;
  bool open_quote = false; ///< whether a quote of it is not closed
  std::size_t part = 0;    ///< which of several files that were joined it is from
};

inline constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

/// The rows that are not empty. A field that begins with a quote ends with one; two stand for one within. A blank as
/// separator stands for any number of blanks and tabs; other fields lose the blanks around them.
/// @param most  rows
std::vector<SheetRow> sheet_rows(std::string_view text, char separator, std::size_t most = all_rows);

/// The separator that a first line "sep=;" names, which is taken off the text.
std::optional<char> named_separator(std::string_view& text);

/// A decimal number and nothing else: no hexadecimal, no "inf", no "1_000".
/// @param comma  whether the comma is the decimal sign
std::optional<double> sheet_number(std::string_view field, bool comma);

/// Whether it would be a number without the signs between its thousands: "1.000,5", "12,345,678".
bool has_thousands_sign(std::string_view field);

/// Whether a field says that there is no value: empty, "NaN", "NA", "None", "-"...
bool says_nothing(std::string_view field);

/// Whether an id says that there is no track: it says nothing, or is a negative number.
bool is_no_track(std::string_view id);

/// The text behind the sign of a comment that it begins with, #, %, // or ;. Nothing if it begins with none.
std::optional<std::string_view> behind_comment_sign(std::string_view text);

} // namespace matrigrate::tracks
