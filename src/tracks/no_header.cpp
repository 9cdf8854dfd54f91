#include "parameters/nearest.hpp"
#include "parameters/scan.hpp"
#include "tracks/header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace matrigrate::tracks {

namespace {

/// The row that is most likely the header: it has columns that the caller names, and many fields.
SheetRow likeliest(std::string_view text, std::optional<char> separator, const TrackOptions& options) {
  SheetRow likeliest;
  double best = -1.0;
  for (const char one : separators) {
    if (separator && one != *separator) continue;
    for (const SheetRow& row : sheet_rows(text, one, deepest_header)) {
      const double named = static_cast<double>(named_columns(row, options));
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
  return n == 4 && whole ? fmt::format("has four columns of whole numbers and no header: if they are those of the Cell "
                                       "Tracking Challenge (man_track.txt: label, begin, end, parent), it has no "
                                       "positions; else tell what they hold: {}",
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
    findings.fault(row.line,
                   fmt::format("{}: there is no column \"{}\"{}; the columns are {}", options.say("columns"),
                               excerpt(name), did_you_mean(nearest(name, row.fields)), names_of(row.fields)),
                   name);
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
  findings.fault(row.line,
                 fmt::format("has no column for {} that is known{}; its columns are {}. Name them: {}",
                             fmt::join(lacking, ", "), options.layout.empty() ? "" : " of " + options.layout,
                             names_of(row.fields), options.say("columns", "track=NAME,t=NAME,x=NAME,y=NAME")));
}

} // namespace matrigrate::tracks
