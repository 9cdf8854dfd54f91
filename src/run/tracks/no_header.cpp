#include "parameters/nearest.hpp"
#include "parameters/scan.hpp"
#include "tracks/header.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace matrigrate::tracks {

namespace {

/// What is said of a text in which no header of tracks was found.
class Complaint {
public:
  Complaint(std::string_view text, std::optional<char> separator, const TrackOptions& options)
      : m_options(options), m_row{} {
    double best = -1.0;
    for (const char one : separators) {
      if (separator && one != *separator) continue;
      for (const SheetRow& row : sheet_rows(text, one, deepest_header)) {
        const double named = static_cast<double>(named_columns(row, options));
        const double fields = std::min(20.0, static_cast<double>(row.fields.size())) / (one == ' ' ? 3.0 : 1.0);
        if (const double score = 100.0 * named + fields; score > best) {
          best = score;
          m_row = row;
        }
      }
    }
    for (const std::string& name : m_row.fields) m_titles.push_back(column_title(name));
  }

  void tell(Findings& findings) const {
    if (m_row.fields.empty()) return findings.fault(0, "is empty");
    const auto has = [&](std::string_view name) { return of_layout({name}, m_titles).has_value(); };
    if (has("number_spots") || has("track_duration") || has("spot_source_id"))
      return findings.fault(m_row.line, fmt::format("is TrackMate's table of {}; export the table of Spots",
                                                    has("spot_source_id") ? "Edges" : "Tracks"));
    if (std::ranges::all_of(m_row.fields, [](const std::string& f) { return is_numeric(f) || says_nothing(f); }))
      return findings.fault(m_row.line, fmt::format("has no header; tell what its {} columns hold, counted from 1: {}",
                                                    m_row.fields.size(), way_out("2", "3", "4", "5")));
    if (tell_unknown_names(findings)) return;
    tell_lacking(findings);
  }

private:
  std::string way_out(const char* track, const char* t, const char* x, const char* y) const {
    return m_options.say("columns", fmt::format("\"track={},t={},x={},y={}\"", track, t, x, y));
  }

  std::string columns() const {
    std::string list;
    for (const std::string& name : m_row.fields)
      if (!name.empty()) list += fmt::format("{}{}", list.empty() ? "" : ", ", excerpt(name, 30));
    return excerpt(list, 300);
  }

  bool tell_unknown_names(Findings& findings) const {
    bool told = false;
    const ColumnNames& own = m_options.columns;
    std::vector<std::pair<std::string_view, std::string>> names{{"track", own.track},
                                                                {"t", own.t},
                                                                {"frame", own.frame},
                                                                {"x", own.x},
                                                                {"y", own.y},
                                                                {"z", own.z},
                                                                {"measured", own.measured},
                                                                {"made_up", own.made_up == "none" ? "" : own.made_up}};
    for (const std::string& name : own.group)
      if (name != "none") names.emplace_back("group", name);
    for (const auto& [key, name] : names) {
      if (name.empty() || of_caller(name, m_row.fields, m_titles)) continue;
      findings.fault(m_row.line,
                     fmt::format("{}: there is no column \"{}\"{}; the columns are {}", m_options.say("columns"),
                                 excerpt(name), did_you_mean(nearest(name, m_row.fields)), columns()));
      told = true;
    }
    return told;
  }

  void tell_lacking(Findings& findings) const {
    const Layout* layout = &layouts().back();
    for (const Layout& one : layouts())
      if (one.name == m_options.layout) layout = &one;
    std::vector<std::string> lacking;
    const auto need = [&](bool there, std::string_view what) {
      if (!there) lacking.emplace_back(what);
    };
    const ColumnNames& own = m_options.columns;
    need(!own.track.empty() || of_layout(layout->track, m_titles), "the track");
    need(!own.t.empty() || !own.frame.empty() || of_layout(layout->t, m_titles) || of_layout(layout->frame, m_titles),
         "the time");
    need(!own.x.empty() || of_layout(layout->x, m_titles), "x");
    need(!own.y.empty() || of_layout(layout->y, m_titles), "y");
    for (const std::string_view name : layout->required) need(of_layout({name}, m_titles).has_value(), name);
    findings.fault(m_row.line,
                   fmt::format("has no column for {} that is known{}; its columns are {}. Name them: {}",
                               fmt::join(lacking, ", "), m_options.layout.empty() ? "" : " of " + m_options.layout,
                               columns(), way_out("NAME", "NAME", "NAME", "NAME")));
  }

  const TrackOptions& m_options;
  SheetRow m_row; ///< the likeliest header
  Titles m_titles;
};

} // namespace

void tell_no_header(std::string_view text, std::optional<char> separator, const TrackOptions& options,
                    Findings& findings) {
  Complaint(text, separator, options).tell(findings);
}

} // namespace matrigrate::tracks
