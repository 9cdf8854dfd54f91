#include "tracks/table.hpp"

#include "tracks/header.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace matrigrate::tracks {

namespace {

/// Whether all columns that the caller names are given by their numbers.
bool only_numbers(const ColumnNames& names) {
  std::size_t count = 0;
  for (const std::string& name : {names.track, names.t, names.frame, names.x, names.y}) {
    if (!name.empty() && !column_number(name)) return false;
    count += name.empty() ? 0 : 1;
  }
  return count >= 4;
}

/// A table without a header, of the columns with these numbers.
std::optional<Table> headerless(std::string_view text, const ColumnNames& names) {
  if (!only_numbers(names) || names.track.empty() || names.x.empty() || names.y.empty()) return std::nullopt;
  Table table;
  const auto column = [](const std::string& name) { return name.empty() ? std::nullopt : column_number(name); };
  table.track = column(names.track);
  table.t = column(names.t);
  table.frame = column(names.frame);
  table.x = column(names.x);
  table.y = column(names.y);
  table.z = column(names.z);
  table.measured = column(names.measured);
  if (names.made_up != "none") table.made_up = column(names.made_up);
  for (const std::string& name : names.group)
    if (const auto number = column(name)) table.group.push_back(*number);
  table.layout = "named";
  std::size_t best = 0;
  for (const char separator : separators) {
    const std::vector<SheetRow> rows = sheet_rows(text, separator, deepest_header);
    const auto fits = [&](const SheetRow& row) {
      const std::size_t n = row.fields.size();
      return *table.track < n && *table.x < n && *table.y < n && is_numeric(row.fields[*table.x])
             && is_numeric(row.fields[*table.y]);
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(rows, fits));
    if (rows.empty() || !fits(rows.front()) || count <= best) continue;
    best = count;
    table.separator = separator;
  }
  if (best == 0) return std::nullopt;
  table.rows = sheet_rows(text, table.separator);
  return table;
}

/// TrackMate writes two rows of titles and one of units below its header. Takes them off the rows.
void take_titles_off(Table& table) {
  const auto field = [](const SheetRow& row, Table::Column c) {
    return c && *c < row.fields.size() ? row.fields[*c] : std::string();
  };
  std::size_t titles = 0;
  const SheetRow* last = nullptr;
  const auto is_title = [&](const SheetRow& row) {
    const auto text = [](const std::string& one) { return !is_numeric(one) && !says_nothing(one); };
    return text(field(row, table.x)) && text(field(row, table.y));
  };
  if (column_title(table.name(table.x)).name != "position_x") return;
  while (titles < 3 && titles < table.rows.size() && is_title(table.rows[titles])) last = &table.rows[titles++];
  if (last == nullptr) return;
  const auto unit = [&](Table::Column c, std::string& own) {
    std::string written = field(*last, c);
    if (!written.starts_with('(')) return;
    std::erase_if(written, [](char b) { return b == '(' || b == ')'; });
    own = lower(trimmed(written));
  };
  unit(table.x, table.x_unit);
  unit(table.y, table.y_unit);
  unit(table.t, table.t_unit);
  table.rows.erase(table.rows.begin(), table.rows.begin() + static_cast<std::ptrdiff_t>(titles));
}

/// R writes names of rows below a header that has none for them.
void mend_row_names(Table& table) {
  const auto longer = [&](const SheetRow& row) { return row.fields.size() == table.header.size() + 1; };
  if (table.separator == ',' || table.separator == ';' || table.rows.empty()
      || !std::ranges::all_of(table.rows, longer))
    return;
  for (SheetRow& row : table.rows) row.fields.erase(row.fields.begin());
}

} // namespace

std::string Table::name(Column column) const {
  if (!column) return {};
  return *column < header.size() ? header[*column] : fmt::format("column {}", *column + 1);
}

std::optional<Table> find_table(std::string_view text, const TrackOptions& options, Findings& findings) {
  const std::optional<char> named = named_separator(text);
  if (auto table = headerless(text, options.columns)) return table;
  std::optional<Table> found;
  std::size_t line = all_rows;
  for (const char separator : separators) {
    if (named && separator != *named) continue;
    for (const SheetRow& row : sheet_rows(text, separator, deepest_header)) {
      if (row.line >= line) break;
      auto table = header_of(row, options);
      if (!table) continue;
      found = std::move(table);
      found->separator = separator;
      line = row.line;
      break;
    }
  }
  if (!found) {
    tell_no_header(text, named, options, findings);
    return std::nullopt;
  }
  found->rows = sheet_rows(text, found->separator);
  std::erase_if(found->rows,
                [line](const SheetRow& row) { return row.line <= line || row.fields[0].starts_with('#'); });
  take_titles_off(*found);
  mend_row_names(*found);
  return found;
}

} // namespace matrigrate::tracks
