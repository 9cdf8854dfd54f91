#include "tracks/table.hpp"

#include "base/text.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace matrigrate::tracks {

namespace {

using Titles = std::vector<ColumnTitle>;

constexpr char separators[] = {'\t', ';', ',', ' '};
constexpr std::size_t deepest_header = 30; ///< rows that are searched for a header
constexpr std::size_t most_columns = 2000;

/// Whether a field is a number, with a point or a comma.
bool is_numeric(std::string_view field) { return sheet_number(field, false) || sheet_number(field, true); }

/// A name of the caller's as the number of a column from 1; nothing if it is none.
/// @return  the number from 0
std::optional<std::size_t> column_number(std::string_view name) {
  const auto number = number_in<std::size_t>(name);
  return number && *number > 0 && *number <= most_columns ? std::optional(*number - 1) : std::nullopt;
}

bool has_unit(const ColumnTitle& title) { return length_unit(title.unit) || time_unit(title.unit); }

/// @param name  of a layout
bool is_named(const ColumnTitle& title, const std::string& before, std::string_view name) {
  if (name.ends_with('*')) return title.name.starts_with(before + std::string(name.substr(0, name.size() - 1)));
  if (name.starts_with('*')) return title.name.find(name.substr(1)) != std::string::npos;
  const std::string whole = before + std::string(name);
  return title.whole == whole || title.name == whole;
}

/// What stands before the name of a track where the layout allows that: "nuclei_" in "nuclei_trackobjects_label_50".
std::string before_name(const Layout::Names& names, const std::string& title) {
  for (const std::string_view name : names)
    if (name.starts_with('*'))
      if (const std::size_t at = title.find(name.substr(1)); at != std::string::npos) return title.substr(0, at);
  return {};
}

/// The column of the first of these names that is there; of several columns of one name the one whose unit is known.
/// @param before  what stands before each name
Table::Column of_layout(const Layout::Names& names, const Titles& titles, const std::string& before = {}) {
  for (const std::string_view name : names) {
    Table::Column found;
    for (std::size_t c = 0; c < titles.size(); ++c)
      if (is_named(titles[c], before, name) && (!found || (!has_unit(titles[*found]) && has_unit(titles[c]))))
        found = c;
    if (found) return found;
  }
  return std::nullopt;
}

/// The column that the caller names: so written, or the same in other letters, or by its number.
Table::Column of_caller(std::string_view name, const std::vector<std::string>& header, const Titles& titles) {
  if (const auto same = std::ranges::find(header, trimmed(name)); same != header.end())
    return static_cast<std::size_t>(same - header.begin());
  const std::string plain = column_title(name).whole;
  for (std::size_t c = 0; c < titles.size(); ++c)
    if (!plain.empty() && titles[c].whole == plain) return c;
  const auto number = column_number(name);
  return number && *number < header.size() ? number : std::nullopt;
}

/// The columns of a row as a header; nothing if it is none.
class HeaderReader {
public:
  HeaderReader(const SheetRow& row, const TrackOptions& options) : m_header(row.fields), m_options(options) {
    if (const auto name = behind_comment_sign(m_header[0])) {
      if (name->empty() && m_header.size() > 3)
        m_header.erase(m_header.begin()); // "# track t x y", by blanks
      else
        m_header[0] = std::string(*name);
    }
    for (const std::string& name : m_header) m_titles.push_back(column_title(name));
  }

  std::optional<Table> table() const {
    if (m_header.size() < 3 || m_header.size() > most_columns) return std::nullopt;
    for (const Layout& layout : layouts())
      if (m_options.layout.empty() || m_options.layout == layout.name)
        if (auto found = of(layout)) return found;
    return std::nullopt;
  }

  /// How many of the columns that the caller names are there.
  std::size_t named() const {
    const ColumnNames& names = m_options.columns;
    std::size_t count = 0;
    for (const std::string& name : {names.track, names.t, names.frame, names.x, names.y})
      count += !name.empty() && of_caller(name, m_header, m_titles) ? 1 : 0;
    return count;
  }

private:
  std::optional<Table> of(const Layout& layout) const {
    for (const std::string_view name : layout.required)
      if (!of_layout({name}, m_titles)) return std::nullopt;
    const ColumnNames& own = m_options.columns;
    Table table;
    table.header = m_header;
    bool all = true; // of the columns that the caller names
    const auto find = [&](const std::string& name, const Layout::Names& names, const std::string& before = {}) {
      if (name.empty()) return of_layout(names, m_titles, before);
      const Table::Column column = of_caller(name, m_header, m_titles);
      all = all && column.has_value();
      return column;
    };
    table.track = find(own.track, layout.track);
    table.t = find(own.t, own.frame.empty() ? layout.t : Layout::Names{});
    table.frame = find(own.frame, own.t.empty() ? layout.frame : Layout::Names{});
    const std::string object = table.track ? before_name(layout.track, m_titles[*table.track].name) : std::string();
    table.x = find(own.x, layout.x, object);
    table.y = find(own.y, layout.y, object);
    table.z = find(own.z, layout.z, object);
    if (!own.measured.empty()) table.measured = find(own.measured, {});
    if (!all || !table.track || !table.x || !table.y || (!table.t && !table.frame)) return std::nullopt;
    const bool named = !own.track.empty() && !own.x.empty() && !own.y.empty() && !(own.t.empty() && own.frame.empty());
    table.layout = named ? "named" : layout.name;
    table.unique = layout.unique && own.track.empty() && own.group.empty();
    if (!add_further(table)) return std::nullopt;
    return table;
  }

  /// Columns that tell movies and made-up positions, and units. @return whether all that the caller names are there
  bool add_further(Table& table) const {
    const ColumnNames& own = m_options.columns;
    for (std::size_t c = 0; c < m_titles.size(); ++c) {
      const bool used = c == table.track || c == table.t || c == table.frame || c == table.x || c == table.y;
      if (own.group.empty() && !used && !table.unique && tells_movies_apart(m_titles[c].name)) table.group.push_back(c);
      if (own.made_up.empty() && tells_made_up(m_titles[c].name)) table.made_up = c;
      if (m_titles[c].name == "space_unit" || (m_titles[c].name == "unit" && table.layout == "imaris")) table.unit = c;
      if (m_titles[c].name == "time_unit") table.time_unit = c;
    }
    for (const std::string& name : own.group) {
      if (name == "none") continue;
      const Table::Column column = of_caller(name, m_header, m_titles);
      if (!column) return false;
      table.group.push_back(*column);
    }
    if (!own.made_up.empty() && own.made_up != "none") {
      table.made_up = of_caller(own.made_up, m_header, m_titles);
      if (!table.made_up) return false;
    }
    const auto unit = [&](Table::Column c) { return c ? m_titles[*c].unit : std::string(); };
    table.x_unit = unit(table.x);
    table.y_unit = unit(table.y);
    table.t_unit = unit(table.t);
    return true;
  }

  std::vector<std::string> m_header;
  const TrackOptions& m_options;
  Titles m_titles;
};

/// The row that is most likely the header: it has columns that the caller names, and many fields.
SheetRow likeliest(std::string_view text, std::optional<char> separator, const TrackOptions& options) {
  SheetRow likeliest;
  double best = -1.0;
  for (const char one : separators) {
    if (separator && one != *separator) continue;
    for (const SheetRow& row : sheet_rows(text, one, deepest_header)) {
      const double named = static_cast<double>(HeaderReader(row, options).named());
      const double fields = std::min(20.0, static_cast<double>(row.fields.size())) / (one == ' ' ? 3.0 : 1.0);
      if (const double score = 100.0 * named + fields; score > best) {
        best = score;
        likeliest = row;
      }
    }
  }
  return likeliest;
}

std::string names_of(const std::vector<std::string>& header) {
  std::string list;
  for (const std::string& name : header)
    if (!name.empty()) list += fmt::format("{}{}", list.empty() ? "" : ", ", excerpt(name, 30));
  return excerpt(list, 300);
}

/// Columns that the caller names and that are not there.
std::vector<std::string> unknown_names(const SheetRow& row, const Titles& titles, const ColumnNames& own) {
  std::vector<std::string> unknown, names{own.track, own.t, own.frame, own.x, own.y, own.z, own.measured, own.made_up};
  names.insert(names.end(), own.group.begin(), own.group.end());
  for (const std::string& name : names)
    if (!name.empty() && name != "none" && !of_caller(name, row.fields, titles)) unknown.push_back(name);
  return unknown;
}

/// Whether columns stand for several tracks: x0, y0, x1, y1, ...
bool is_wide(const Titles& titles) {
  std::size_t x = 0, y = 0;
  for (const ColumnTitle& title : titles) {
    std::string name = title.name;
    std::erase_if(name, [](char c) { return (c >= '0' && c <= '9') || c == '_' || c == ' ' || c == '.' || c == '-'; });
    if (name.size() == title.name.size()) continue;
    x += name == "x" || name.ends_with("cellx") || name.ends_with("trackx") || name.starts_with("xcell") ? 1 : 0;
    y += name == "y" || name.ends_with("celly") || name.ends_with("tracky") || name.starts_with("ycell") ? 1 : 0;
  }
  return x >= 2 && y >= 2;
}

/// What a row of numbers alone tells.
std::string without_header(const SheetRow& row, const TrackOptions& options) {
  const std::size_t n = row.fields.size();
  const bool whole = std::ranges::all_of(
      row.fields, [](const std::string& f) { return f.find_first_not_of("0123456789") == std::string::npos; });
  const std::string first = n > 4 ? "track=2,t=3,x=4,y=5" : "track=1,t=2,x=3,y=4";
  return n == 4 && whole ? fmt::format(
             "has four columns of whole numbers and no header: if they are those of the Cell Tracking Challenge "
             "(man_track.txt: label, begin, end, parent), it has no positions; else tell what they hold: {}",
             options.say("columns", first))
                         : fmt::format("has no header; tell what its {} columns hold, counted from 1: {}", n,
                                       options.say("columns", first));
}

/// What a table of a known kind lacks; empty if it is of none.
std::string known_kind(const Titles& titles) {
  const auto has = [&](std::string_view name) { return of_layout({name}, titles).has_value(); };
  if (has("spot_source_id")) return "is TrackMate's table of Edges; export the table of Spots";
  if (has("number_spots") || has("track_duration")) return "is TrackMate's table of Tracks; export the table of Spots";
  if (has("*trackobjects_label"))
    return "is CellProfiler's table without Location_Center_X and _Y: export the location of the object "
           "(MeasureObjectSizeAndShape); TrackObjects_Trajectory are steps";
  return is_wide(titles) ? "has a pair of columns for each track: write a row for each position, with the columns "
                           "track, frame, x, y"
                         : "";
}

/// Tells why no header of tracks was found in a text, and the way out.
void tell_no_header(std::string_view text, std::optional<char> separator, const TrackOptions& options,
                    Findings& findings) {
  const SheetRow row = likeliest(text, separator, options);
  if (row.fields.empty()) return findings.fault(0, "is empty");
  Titles titles;
  for (const std::string& name : row.fields) titles.push_back(column_title(name));
  const std::vector<std::string> unknown = unknown_names(row, titles, options.columns);
  if (const std::string kind = known_kind(titles); !kind.empty() && unknown.empty())
    return findings.fault(row.line, kind);
  if (std::ranges::all_of(row.fields, [](const std::string& f) { return is_numeric(f) || says_nothing(f); }))
    return findings.fault(row.line, without_header(row, options));
  for (const std::string& name : unknown)
    findings.fault_of_kind(name, row.line,
                           fmt::format("{}: there is no column \"{}\"{}; the columns are {}", options.say("columns"),
                                       excerpt(name), did_you_mean(nearest(name, row.fields)), names_of(row.fields)));
  if (!unknown.empty()) return;
  const Layout* layout = &layouts().back();
  for (const Layout& one : layouts())
    if (one.name == options.layout) layout = &one;
  const ColumnNames& own = options.columns;
  const auto known = [&](const Layout::Names& names) { return of_layout(names, titles).has_value(); };
  std::vector<std::string_view> lacking;
  if (own.track.empty() && !known(layout->track)) lacking.emplace_back("the track");
  if (own.t.empty() && own.frame.empty() && !known(layout->t) && !known(layout->frame))
    lacking.emplace_back("the time");
  if (own.x.empty() && !known(layout->x)) lacking.emplace_back("x");
  if (own.y.empty() && !known(layout->y)) lacking.emplace_back("y");
  for (const std::string_view name : layout->required)
    if (!known({name})) lacking.push_back(name);
  findings.fault(row.line, "has no column for {} that is known{}; its columns are {}. Name them: {}",
                 fmt::join(lacking, ", "), options.layout.empty() ? "" : " of " + options.layout, names_of(row.fields),
                 options.say("columns", "track=NAME,t=NAME,x=NAME,y=NAME"));
}

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
      auto table = HeaderReader(row, options).table();
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
