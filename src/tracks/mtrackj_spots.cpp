#include "parameters/document.hpp"
#include "tracks/sheet.hpp"
#include "tracks/spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace matrigrate::tracks {

namespace {

/// Reads the lines of MTrackJ's data file: "Cluster 1", "Track 2", "Point 1 x y z t c".
class PointReader {
public:
  PointReader(std::string_view text, Findings& findings) : m_rows(sheet_rows(text, ' ')), m_findings(findings) {}

  Spots spots() {
    m_spots.layout = "mtrackj";
    m_spots.separator = ' ';
    m_spots.length_unit = "pixel";
    m_spots.columns = {
        .track = "Track", .t = {}, .frame = "t", .x = "x", .y = "y", .made_up = {}, .measured = {}, .group = {}};
    const auto several = [&](const char* what) {
      return std::ranges::count_if(m_rows, [&](const SheetRow& row) { return row.fields[0] == what; }) > 1;
    };
    const bool assemblies = several("Assembly"), clusters = assemblies || several("Cluster");
    std::string assembly, cluster;
    for (const SheetRow& row : m_rows) {
      const std::string& what = row.fields[0];
      const std::string id = row.fields.size() > 1 ? row.fields[1] : "";
      if (what == "Assembly") assembly = assemblies ? id + "/" : "";
      if (what == "Cluster") cluster = clusters ? id + "/" : "";
      if (what == "Track") m_track = track(assembly + cluster + id);
      if (what == "Point") point(row);
    }
    if (m_rows.back().fields[0] != "End")
      m_findings.fault(m_rows.back().line, "is cut short: its last line is not \"End of MTrackJ Data File\"");
    if (m_heights.size() > 1) m_findings.note("z is left out: read-outs are of the projection on the plane");
    return std::move(m_spots);
  }

private:
  std::size_t track(const std::string& name) {
    const auto [own, added] = m_numbers.emplace(name, m_spots.names.size());
    if (added) m_spots.names.push_back(name);
    return own->second;
  }

  void point(const SheetRow& row) {
    if (m_spots.names.empty()) return m_findings.fault(row.line, "has a point in no track");
    if (row.fields.size() < 6)
      return m_findings.fault(row.line, fmt::format("has {} words; Point ID x y z t are wanted", row.fields.size()));
    const auto number = [&](std::size_t field, const char* name) {
      const auto value = sheet_number(row.fields[field], false);
      if (!value)
        m_findings.fault(row.line, fmt::format("{}: \"{}\" is no finite number", name, excerpt(row.fields[field])));
      return value;
    };
    const auto x = number(2, "x"), y = number(3, "y"), frame = number(5, "t");
    m_heights.insert(row.fields[4]);
    if (x && y && frame)
      m_spots.spots.push_back({.track = m_track, .frame = *frame, .x = *x, .y = *y, .line = row.line});
  }

  std::vector<SheetRow> m_rows;
  Findings& m_findings;
  Spots m_spots;
  std::map<std::string, std::size_t> m_numbers; ///< of tracks, by their names
  std::set<std::string> m_heights;
  std::size_t m_track = 0;
};

} // namespace

Spots mtrackj_spots(std::string_view text, Findings& findings) { return PointReader(text, findings).spots(); }

} // namespace matrigrate::tracks
