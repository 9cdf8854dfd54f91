#pragma once

#include "tracks/layouts.hpp"
#include "tracks/options.hpp"
#include "tracks/table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The header of a table: which of its names are known, and for what. Test: tests/unit/tracks/text_test.cpp
namespace matrigrate::tracks {

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
