#pragma once

#include "tracks/table.hpp"

#include <optional>
#include <string_view>

/// How the numbers and the times of a table are written. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

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
