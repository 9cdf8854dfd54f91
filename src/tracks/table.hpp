#pragma once

#include "tracks/findings.hpp"
#include "tracks/layouts.hpp"
#include "tracks/options.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// From the bytes of a file to the table in it: its text, its rows of fields, its header, which column holds what, and
/// how its numbers and times are written. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

struct Text {
  std::string utf8;     ///< lines end with \n, minus signs are "-", blanks " "
  std::string encoding; ///< "UTF-8", "UTF-16" or "Windows-1252"
};

/// Takes UTF-8, UTF-16 with its mark, and what is neither as Windows-1252 (which has Latin-1 in it), with a note. A
/// workbook, a compressed file and what is no text are faults.
Text decoded(std::string_view bytes, Findings& findings);

struct SheetRow {
  std::size_t line = 0; ///< where it begins, from 1
  std::vector<std::string> fields;
  bool open_quote = false; ///< whether a quote of it is not closed
  std::size_t part = 0;    ///< which of several files that were joined it is from

  /// That of a column from 0; empty where it has none.
  const std::string& field(std::optional<std::size_t> column) const;
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

struct Table {
  using Column = std::optional<std::size_t>; ///< number from 0

  std::string layout; ///< "trackmate", ...; "named" if the caller names all columns
  char separator = ',';
  std::vector<std::string> header; ///< empty if it has none
  Column track, t, frame, x, y, z, made_up, measured;
  Column unit, time_unit; ///< of the length and of t, in each row
  std::vector<std::size_t> group;
  bool unique = false;                ///< whether ids do not repeat over groups
  std::string x_unit, y_unit, t_unit; ///< as the header states them
  std::vector<SheetRow> rows;         ///< of data
  std::size_t parts = 1;              ///< files that were joined; their number is a column behind the last

  /// "POSITION_X", or "column 3" without a header; empty if there is none.
  std::string name(Column column) const;
};

/// @return nothing, and a fault that names the way out, if the text has no table of tracks
std::optional<Table> find_table(std::string_view text, const TrackOptions& options, Findings& findings);

struct NumberSigns {
  char decimal = '.';
  char thousands = '\0'; ///< none
};

/// The signs of the numbers of places and times, with a note if they are not points alone; a fault if they cannot be
/// told. A sign with three digits behind it each time, in a column that has other numbers without any, separates
/// thousands.
NumberSigns number_signs(const Table& table, Findings& findings);

/// A number as sheet_number(), with these signs; blanks and apostrophes between thousands do not count.
std::optional<double> number_of(std::string_view field, const NumberSigns& signs);

/// How the times of a column are written: as numbers, or by the clock.
struct Clock {
  bool runs = false;
  bool hours = true;   ///< whether "02:03" are hours and minutes, not minutes and seconds
  double origin = 0.0; ///< of times with a date: that of the first [s]
};

/// A fault if times by the clock can be read in two ways.
Clock clock_of(const Table& table, Findings& findings);

/// "1:02:03.5", "02:03.5", "1 days 00:02:00", "2024-05-03T10:05:00Z", "3.5.2024 10:05", "10:05:00 PM" in s.
std::optional<double> clock_time(std::string_view field, const Clock& clock);

} // namespace matrigrate::tracks
