#pragma once

#include "tracks/findings.hpp"
#include "tracks/options.hpp"
#include "tracks/sheet.hpp"

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

} // namespace matrigrate::tracks
