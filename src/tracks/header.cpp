#include "tracks/table.hpp"

#include "base/text.hpp"
#include "parameters/document.hpp"
#include "parameters/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace matrigrate::tracks {

namespace {

using Titles = std::vector<ColumnTitle>;

constexpr std::size_t most_columns = 2000;

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

} // namespace

std::optional<std::size_t> column_number(std::string_view name) {
  const auto number = number_in<std::size_t>(name);
  return number && *number > 0 && *number <= most_columns ? std::optional(*number - 1) : std::nullopt;
}

std::optional<Table> header_of(const SheetRow& row, const TrackOptions& options) {
  return HeaderReader(row, options).table();
}

bool is_numeric(std::string_view field) { return sheet_number(field, false) || sheet_number(field, true); }

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

} // namespace matrigrate::tracks
