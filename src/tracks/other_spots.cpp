#include "parameters/document.hpp"
#include "tracks/layouts.hpp"
#include "tracks/spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

// Files that are no tables.
namespace matrigrate::tracks {

namespace {

/// A tag of XML with its attributes.
struct Tag {
  std::string name; ///< "/particle" of one that closes
  std::map<std::string, std::string> attributes;
  bool closed = false; ///< <detection ... />
  std::size_t line = 0;
};

/// Reads the tags of a text that is as flat as TrackMate's tracks; text between them does not matter.
class TagReader {
public:
  explicit TagReader(std::string_view text) : m_text(text) {}

  /// The next tag; nothing at the end, or if the text is no XML from here on (fault()).
  std::optional<Tag> next() {
    while (skip_to_tag()) {
      if (over("<?", "?>") || over("<!--", "-->") || over("<!", ">")) continue;
      if (!m_fault.empty()) return std::nullopt;
      return tag();
    }
    return std::nullopt;
  }

  const std::string& fault() const { return m_fault; }
  std::size_t line() const { return m_line; }

private:
  bool skip_to_tag() {
    const std::size_t open = m_fault.empty() ? m_text.find('<', m_at) : std::string_view::npos;
    if (open == std::string_view::npos) return false;
    move_to(open);
    return true;
  }

  void move_to(std::size_t at) {
    m_line += static_cast<std::size_t>(std::count(m_text.begin() + static_cast<std::ptrdiff_t>(m_at),
                                                  m_text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    m_at = at;
  }

  /// Passes over what begins and ends so. @return whether it began so, and ended
  bool over(std::string_view begin, std::string_view end) {
    if (!m_text.substr(m_at).starts_with(begin)) return false;
    const std::size_t close = m_text.find(end, m_at + begin.size());
    if (close == std::string_view::npos) {
      m_fault = fmt::format("{} is not closed", begin);
      return false;
    }
    move_to(close + end.size());
    return true;
  }

  static bool ends_name(char c) {
    return c == '>' || c == '/' || c == '=' || c == '<' || c == ' ' || c == '\n' || c == '\t';
  }

  std::string word() {
    const std::size_t from = m_at;
    while (m_at < m_text.size() && (!ends_name(m_text[m_at]) || (m_at == from && m_text[m_at] == '/'))) ++m_at;
    return std::string(m_text.substr(from, m_at - from));
  }

  void skip_blanks() {
    std::size_t at = m_at;
    while (at < m_text.size() && (m_text[at] == ' ' || m_text[at] == '\n' || m_text[at] == '\t')) ++at;
    move_to(at);
  }

  std::optional<Tag> tag() {
    Tag tag{.name = {}, .attributes = {}, .line = m_line};
    ++m_at;
    tag.name = word();
    for (skip_blanks(); m_at < m_text.size() && m_text[m_at] != '>'; skip_blanks()) {
      if (m_text[m_at] == '/') {
        tag.closed = true;
        ++m_at;
      } else if (!attribute(tag)) {
        m_fault = fmt::format("the tag <{}> has an attribute that is none", excerpt(tag.name));
        return std::nullopt;
      }
    }
    if (m_at >= m_text.size()) {
      m_fault = fmt::format("the tag <{}> is not closed: the file is cut short", excerpt(tag.name));
      return std::nullopt;
    }
    ++m_at;
    return tag;
  }

  bool attribute(Tag& tag) {
    const std::string name = word();
    skip_blanks();
    if (name.empty() || m_at >= m_text.size() || m_text[m_at] != '=') return false;
    ++m_at;
    skip_blanks();
    if (m_at >= m_text.size() || (m_text[m_at] != '"' && m_text[m_at] != '\'')) return false;
    const std::size_t close = m_text.find(m_text[m_at], m_at + 1);
    if (close == std::string_view::npos) return false;
    tag.attributes[name] = m_text.substr(m_at + 1, close - m_at - 1);
    move_to(close + 1);
    return true;
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  std::size_t m_line = 1;
  std::string m_fault;
};

std::string attribute(const Tag& tag, const std::string& name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? std::string() : found->second;
}

/// "&#181;m" and "&#xB5;m" are um as well.
std::string unit_text(std::string text) {
  for (const std::string_view micro : {"&#181;", "&#xb5;", "&#xB5;", "&micro;", "&#956;", "&#x3bc;", "&#x3BC;"})
    if (text.starts_with(micro)) text = "u" + text.substr(micro.size());
  return text;
}

std::optional<double> finite_number(const std::string& text, const char* name, std::size_t line, Findings& findings) {
  const auto value = sheet_number(text, false);
  if (!value) findings.fault(line, "{}: \"{}\" is no finite number", name, excerpt(text));
  return value;
}

Spots begun(std::string layout, std::string track) {
  Spots spots;
  spots.layout = std::move(layout);
  spots.columns = {.track = std::move(track),
                   .t = {},
                   .frame = "t",
                   .x = "x",
                   .y = "y",
                   .z = {},
                   .group = {},
                   .made_up = {},
                   .measured = {}};
  return spots;
}

void tell_heights(const std::set<std::string>& heights, Findings& findings) {
  if (heights.size() > 1) findings.note("z is left out: read-outs are of the projection on the plane");
}

} // namespace

Spots xml_spots(std::string_view text, Findings& findings) {
  TagReader reader(text);
  const auto root = reader.next();
  if (!root || root->name != "Tracks") {
    findings.fault(root ? root->line : 0,
                   root ? fmt::format("its root is <{}>; TrackMate's \"Export tracks to XML file\" writes <Tracks>",
                                      excerpt(root->name))
                        : "is no XML: " + reader.fault());
    return {};
  }
  Spots spots = begun("xml", "particle");
  spots.length_unit = unit_text(attribute(*root, "spaceUnits"));
  spots.time_unit = attribute(*root, "timeUnits");
  double step = sheet_number(attribute(*root, "frameInterval"), false).value_or(0.0);
  if (step > 0.0 && time_unit(spots.time_unit))
    spots.columns.t = "frameInterval";
  else
    step = 1.0;
  std::set<std::string> heights;
  bool closed = root->closed;
  while (!closed) {
    const auto tag = reader.next();
    if (!tag) break;
    closed = tag->name == "/Tracks";
    if (tag->name == "particle") spots.names.push_back(std::to_string(spots.names.size() + 1));
    if (tag->name != "detection") continue;
    const auto number = [&](const char* name) {
      return finite_number(attribute(*tag, name), name, tag->line, findings);
    };
    const auto frame = number("t"), x = number("x"), y = number("y");
    heights.insert(attribute(*tag, "z"));
    if (spots.names.empty())
      findings.fault(tag->line, "has a detection in no particle");
    else if (frame && x && y)
      spots.spots.push_back(
          {.track = spots.names.size() - 1, .t = *frame * step, .frame = *frame, .x = *x, .y = *y, .line = tag->line});
  }
  if (!closed)
    findings.fault(reader.line(),
                   reader.fault().empty() ? "is cut short: </Tracks> is missing" : "is no XML: " + reader.fault());
  tell_heights(heights, findings);
  return spots;
}

// Its lines: "Cluster 1", "Track 2", "Point 1 x y z t c".
Spots mtrackj_spots(std::string_view text, Findings& findings) {
  const std::vector<SheetRow> rows = sheet_rows(text, ' ');
  Spots spots = begun("mtrackj", "Track");
  spots.separator = ' ';
  spots.length_unit = "pixel";
  const auto several = [&](const char* what) {
    return std::ranges::count_if(rows, [&](const SheetRow& row) { return row.fields[0] == what; }) > 1;
  };
  const bool assemblies = several("Assembly"), clusters = assemblies || several("Cluster");
  std::string assembly, cluster;
  std::map<std::string, std::size_t> numbers; // of tracks, by their names
  std::set<std::string> heights;
  std::size_t track = 0;
  const auto point = [&](const SheetRow& row) {
    if (spots.names.empty()) return findings.fault(row.line, "has a point in no track");
    if (row.fields.size() < 6)
      return findings.fault(row.line, "has {} words; Point ID x y z t are wanted", row.fields.size());
    const auto x = finite_number(row.fields[2], "x", row.line, findings);
    const auto y = finite_number(row.fields[3], "y", row.line, findings);
    const auto frame = finite_number(row.fields[5], "t", row.line, findings);
    heights.insert(row.fields[4]);
    if (x && y && frame) spots.spots.push_back({.track = track, .frame = *frame, .x = *x, .y = *y, .line = row.line});
  };
  for (const SheetRow& row : rows) {
    const std::string& what = row.fields[0];
    const std::string id = row.fields.size() > 1 ? row.fields[1] : "";
    if (what == "Assembly") assembly = assemblies ? id + "/" : "";
    if (what == "Cluster") cluster = clusters ? id + "/" : "";
    if (what == "Track") {
      const std::string name = assembly + cluster + id;
      const auto [own, added] = numbers.emplace(name, spots.names.size());
      if (added) spots.names.push_back(name);
      track = own->second;
    }
    if (what == "Point") point(row);
  }
  if (rows.back().fields[0] != "End")
    findings.fault(rows.back().line, "is cut short: its last line is not \"End of MTrackJ Data File\"");
  tell_heights(heights, findings);
  return spots;
}

} // namespace matrigrate::tracks
