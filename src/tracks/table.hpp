#pragma once

#include "tracks/findings.hpp"
#include "tracks/layouts.hpp"
#include "tracks/options.hpp"
#include "tracks/sheet.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The table in a text: its separator, its header, which column holds what. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

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

using Titles = std::vector<ColumnTitle>;

/// The column of the first of these names that is there; of several columns of one name the one whose unit is known.
/// @param before  what stands before each name
Table::Column of_layout(const Layout::Names& names, const Titles& titles, const std::string& before = {});

/// A name of the caller's as the number of a column from 1; nothing if it is none.
/// @return  the number from 0
std::optional<std::size_t> column_number(std::string_view name);

/// The column that the caller names: so written, or the same in other letters, or by its number.
Table::Column of_caller(std::string_view name, const std::vector<std::string>& header, const Titles& titles);

/// A row as a header: a table without its rows. Nothing if it is none.
std::optional<Table> header_of(const SheetRow& row, const TrackOptions& options);

/// How many of the columns that the caller names a row has.
std::size_t named_columns(const SheetRow& row, const TrackOptions& options);

/// Whether a field is a number, with a point or a comma.
bool is_numeric(std::string_view field);

/// Tells why no header of tracks was found in a text, and the way out.
void tell_no_header(std::string_view text, std::optional<char> separator, const TrackOptions& options,
                    Findings& findings);

/// Where a separator is looked for: tab, semicolon, comma, blanks.
inline constexpr char separators[] = {'\t', ';', ',', ' '};
inline constexpr std::size_t deepest_header = 30; ///< rows that are searched for a header
inline constexpr std::size_t most_columns = 2000;

} // namespace matrigrate::tracks
