#include "parameters/document.hpp"
#include "tracks/layouts.hpp"
#include "tracks/sheet.hpp"
#include "tracks/spots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

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

/// Reads the detections of TrackMate's particles.
class ParticleReader {
public:
  ParticleReader(std::string_view text, Findings& findings) : m_reader(text), m_findings(findings) {}

  Spots spots() {
    const auto root = m_reader.next();
    if (!root || root->name != "Tracks") {
      m_findings.fault(root ? root->line : 0,
                       root ? fmt::format("its root is <{}>; TrackMate's \"Export tracks to XML file\" writes <Tracks>",
                                          excerpt(root->name))
                            : "is no XML: " + m_reader.fault());
      return {};
    }
    head(*root);
    bool closed = root->closed;
    while (!closed) {
      const auto tag = m_reader.next();
      if (!tag) break;
      closed = tag->name == "/Tracks";
      if (tag->name == "particle") m_spots.names.push_back(std::to_string(m_spots.names.size() + 1));
      if (tag->name == "detection") detection(*tag);
    }
    if (!closed)
      m_findings.fault(m_reader.line(), m_reader.fault().empty() ? "is cut short: </Tracks> is missing"
                                                                 : "is no XML: " + m_reader.fault());
    if (m_heights.size() > 1) m_findings.note("z is left out: read-outs are of the projection on the plane");
    return std::move(m_spots);
  }

private:
  void head(const Tag& root) {
    m_spots.layout = "xml";
    m_spots.length_unit = unit_text(attribute(root, "spaceUnits"));
    m_spots.columns = {
        .track = "particle", .t = {}, .frame = "t", .x = "x", .y = "y", .made_up = {}, .measured = {}, .group = {}};
    m_spots.time_unit = attribute(root, "timeUnits");
    const auto step = sheet_number(attribute(root, "frameInterval"), false);
    if (step && *step > 0.0 && time_unit(m_spots.time_unit)) {
      m_step = *step;
      m_spots.columns.t = "frameInterval";
    }
  }

  void detection(const Tag& tag) {
    const auto number = [&](const char* name) {
      const std::string text = attribute(tag, name);
      const auto value = sheet_number(text, false);
      if (!value) m_findings.fault(tag.line, fmt::format("{}: \"{}\" is no finite number", name, excerpt(text)));
      return value;
    };
    const auto frame = number("t"), x = number("x"), y = number("y");
    m_heights.insert(attribute(tag, "z"));
    if (m_spots.names.empty()) return m_findings.fault(tag.line, "has a detection in no particle");
    if (frame && x && y)
      m_spots.spots.push_back({.track = m_spots.names.size() - 1,
                               .t = *frame * m_step,
                               .frame = *frame,
                               .x = *x,
                               .y = *y,
                               .line = tag.line});
  }

  TagReader m_reader;
  Findings& m_findings;
  Spots m_spots;
  double m_step = 1.0;
  std::set<std::string> m_heights;
};

} // namespace

Spots xml_spots(std::string_view text, Findings& findings) { return ParticleReader(text, findings).spots(); }

} // namespace matrigrate::tracks
