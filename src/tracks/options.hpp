#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What a caller says of a file of measured tracks. Test: tests/unit/tracks/reading_test.cpp
namespace matrigrate::tracks {

/// Names of columns as in the header, or their numbers from 1; empty where the reader is to find them.
struct ColumnNames {
  std::string track, t, frame, x, y, z;
  std::vector<std::string> group; ///< tell movies apart in which ids repeat; "none": there are none
  std::string made_up;  ///< true where a tracker has put a position that it did not see; "none": there is none
  std::string measured; ///< false where it has
};

/// Key and name of each in "track=Track n°,x=X [um],...". A comma belongs to a name unless a key and "=" follow it.
/// @throws std::invalid_argument saying what is wrong
std::vector<std::pair<std::string, std::string>> column_pairs(std::string_view text);

/// @throws std::invalid_argument as column_pairs(), and if a column is named twice
void add_columns(std::string_view text, ColumnNames& names);

/// What is done with a track that has two positions at one time.
enum class Splits {
  refuse,
  cut, ///< it ends before that time
  drop ///< it is left out
};

/// An option in a message, in the words of a front end: one of the command line, a key of a study file, an argument of
/// Python. Without a value its name alone.
/// @param value  of columns "track=NAME,t=2", of a flag "true"
using Wording = std::function<std::string(std::string_view option, std::string_view value)>;

/// "{interval S}", "{interval}": for a front end that words them later, as R.
std::string as_record(std::string_view option, std::string_view value);

struct TrackOptions {
  std::optional<double> pixel;    ///< um per unit of length of the file
  std::optional<double> interval; ///< s from frame to frame
  std::string time_unit;          ///< of the column of time: one of time_units(); empty: what the file states
  ColumnNames columns{};
  std::string layout; ///< only the names of this one; empty: of any
  Splits splits = Splits::refuse;
  double jitter = 0.1;      ///< by which a step may differ from the interval, as a share of it
  std::size_t shortest = 4; ///< tracks of fewer positions are left out
  std::size_t fewest = 2;   ///< fewer tracks are refused
  bool may_stand = false;   ///< whether tracks without any motion are taken
  Wording wording = as_record;

  std::string say(std::string_view option, std::string_view value = {}) const { return wording(option, value); }
};

/// "ms", "s", "min", "h", "d".
const std::vector<std::string>& time_units();

/// The names of the layouts.
std::vector<std::string> layout_names();

/// What is wrong with the values of the options themselves, one sentence each.
std::vector<std::string> faults_of(const TrackOptions& options);

/// Sets what is given in words: columns, each as add_columns() reads them, and splits.
/// @return what is wrong with them, and with the other options, one sentence each
std::vector<std::string> set_words(TrackOptions& options, const std::vector<std::string>& columns,
                                   std::string_view splits);

} // namespace matrigrate::tracks
