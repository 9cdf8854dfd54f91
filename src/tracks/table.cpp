#include "tracks/table.hpp"

#include "tracks/layouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
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
      return *table.track < row.fields.size() && is_numeric(row.field(table.x)) && is_numeric(row.field(table.y));
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
/// @return  their fields
std::vector<std::vector<std::string>> take_titles_off(Table& table) {
  std::size_t titles = 0;
  const SheetRow* last = nullptr;
  const auto is_title = [&](const SheetRow& row) {
    const auto text = [](const std::string& one) { return !is_numeric(one) && !says_nothing(one); };
    return text(row.field(table.x)) && text(row.field(table.y));
  };
  if (column_title(table.name(table.x)).name != "position_x") return {};
  while (titles < 3 && titles < table.rows.size() && is_title(table.rows[titles])) last = &table.rows[titles++];
  if (last == nullptr) return {};
  const auto unit = [&](Table::Column c, std::string& own) {
    std::string written = last->field(c);
    if (!written.starts_with('(')) return;
    std::erase_if(written, [](char b) { return b == '(' || b == ')'; });
    own = lower(trimmed(written));
  };
  unit(table.x, table.x_unit);
  unit(table.y, table.y_unit);
  unit(table.t, table.t_unit);
  std::vector<std::vector<std::string>> fields;
  for (std::size_t k = 0; k < titles; ++k) fields.push_back(std::move(table.rows[k].fields));
  table.rows.erase(table.rows.begin(), table.rows.begin() + static_cast<std::ptrdiff_t>(titles));
  return fields;
}

/// "line 5", "lines 5, 9, 12 ...".
std::string lines_text(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 3;
  const std::span<const std::size_t> named(lines.data(), std::min(most, lines.size()));
  return fmt::format("line{} {}{}", lines.size() == 1 ? "" : "s", fmt::join(named, ", "),
                     lines.size() > most ? " ..." : "");
}

/// Files that were joined have the header in the middle, too. Such rows are taken off; each row gets the number of its
/// file.
void take_headers_off(Table& table, const std::vector<std::vector<std::string>>& titles, Findings& findings) {
  std::vector<std::size_t> lines;
  for (SheetRow& row : table.rows) {
    if (row.fields == titles.front()) lines.push_back(row.line);
    row.part = lines.size();
  }
  if (!lines.empty())
    std::erase_if(table.rows,
                  [&](const SheetRow& row) { return std::ranges::find(titles, row.fields) != titles.end(); });
  table.parts = lines.size() + 1;
  if (!lines.empty())
    findings.note("{} {} the header: {} were joined", lines_text(lines), lines.size() == 1 ? "repeats" : "repeat",
                  counted(table.parts, "file"));
}

/// Whether a row may be one of a table: it has what may be numbers where a position has them.
bool has_position(const SheetRow& row, const Table& table) {
  return std::ranges::all_of(std::array{*table.x, *table.y}, [&](std::size_t c) {
    const std::string& field = row.field(c);
    return c < row.fields.size() && (is_numeric(field) || says_nothing(field) || has_thousands_sign(field));
  });
}

/// Takes comments within a table off its rows, and lines below it: they begin with a word that is no id of a track, and
/// have no time.
void take_remarks_off(Table& table, Findings& findings) {
  std::vector<std::size_t> lines;
  std::erase_if(table.rows, [&](const SheetRow& row) {
    const bool opens = behind_comment_sign(row.fields[0]) || (table.separator == ';' && row.fields[0].empty());
    if (!opens || has_position(row, table)) return false;
    lines.push_back(row.line);
    return true;
  });
  if (!lines.empty())
    findings.note("{} within the table {} left out ({})", counted(lines.size(), "comment"),
                  lines.size() == 1 ? "is" : "are", lines_text(lines));
  const Table::Column time = table.frame ? table.frame : table.t;
  std::set<std::string> ids;
  for (const SheetRow& row : table.rows)
    if (const std::string& at = row.field(time); !at.empty() && at[0] >= '0' && at[0] <= '9')
      ids.insert(row.field(table.track));
  lines.clear();
  const auto is_footer = [&](const SheetRow& row) {
    const std::string& first = *std::ranges::find_if(row.fields, [](const std::string& f) { return !f.empty(); });
    return !is_numeric(first) && !is_numeric(row.field(time)) && !ids.contains(first) && !row.open_quote
           && !ids.contains(row.field(table.track));
  };
  for (; !table.rows.empty() && !ids.empty() && is_footer(table.rows.back()); table.rows.pop_back())
    lines.insert(lines.begin(), table.rows.back().line);
  if (!lines.empty())
    findings.note("{} below the table {} left out ({})", counted(lines.size(), "line"),
                  lines.size() == 1 ? "is" : "are", lines_text(lines));
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
  if (parts > 1 && *column == header.size()) return "the file that was joined";
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
  const auto head = std::ranges::find(found->rows, line, &SheetRow::line);
  std::vector<std::vector<std::string>> titles{head->fields};
  found->rows.erase(found->rows.begin(), head + 1);
  for (auto& fields : take_titles_off(*found)) titles.push_back(std::move(fields));
  take_headers_off(*found, titles, findings);
  take_remarks_off(*found, findings);
  mend_row_names(*found);
  return found;
}

} // namespace matrigrate::tracks
