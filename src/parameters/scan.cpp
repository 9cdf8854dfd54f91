#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace matrigrate {

namespace {

constexpr int deepest = 32;
constexpr int max_dotted_keys = 50'000;

/// Follows strings, comments and brackets of a TOML text, byte by byte. On a text that is not valid TOML it agrees with
/// a parser up to the first error, which is as far as the parser goes.
class Follower {
public:
  /// Moves over text[i] and what belongs to it. @return index of the next byte
  std::size_t over(std::string_view text, std::size_t i) {
    const char c = text[i];
    if (c == '\n') return end_line(i);
    if (m_in == In::comment) return i + 1;
    if (m_in != In::plain) return over_string(text, i);
    if (c == '#') m_in = In::comment;
    if (c == '"' || c == '\'') return open_string(text, i);
    if (c == '[' || c == '{') ++m_brackets;
    if (c == ']' || c == '}') m_brackets = std::max(0, m_brackets - 1);
    if (c == '.') ++m_dots;
    if (c == '=' && m_dots > 0) ++m_dotted_keys;
    if (std::string_view("[]{},=#").find(c) != std::string_view::npos) m_dots = 0;
    return i + 1;
  }

  bool too_deep() const { return m_brackets > deepest || m_dots > deepest; }
  bool too_dotted() const { return m_dotted_keys > max_dotted_keys; }

private:
  enum class In { plain, comment, basic, literal, long_basic, long_literal };

  std::size_t end_line(std::size_t i) {
    if (m_in != In::long_basic && m_in != In::long_literal) m_in = In::plain;
    m_dots = 0;
    return i + 1;
  }

  std::size_t open_string(std::string_view text, std::size_t i) {
    const bool basic = text[i] == '"';
    const bool is_long = text.substr(i).starts_with(basic ? "\"\"\"" : "'''");
    if (is_long)
      m_in = basic ? In::long_basic : In::long_literal;
    else
      m_in = basic ? In::basic : In::literal;
    return i + (is_long ? 3 : 1);
  }

  std::size_t over_string(std::string_view text, std::size_t i) {
    const bool basic = m_in == In::basic || m_in == In::long_basic;
    const bool is_long = m_in == In::long_basic || m_in == In::long_literal;
    const char quote = basic ? '"' : '\'';
    if (basic && text[i] == '\\' && i + 1 < text.size() && text[i + 1] != '\n') return i + 2;
    if (text[i] != quote) return i + 1;
    if (!is_long) {
      m_in = In::plain;
      return i + 1;
    }
    std::size_t run = 0; // up to two quotes may stand before the three that close
    while (run < 5 && i + run < text.size() && text[i + run] == quote) ++run;
    if (run >= 3) m_in = In::plain;
    return i + run;
  }

  In m_in = In::plain;
  int m_brackets = 0;
  int m_dots = 0; ///< since the last character that ends a dotted key
  int m_dotted_keys = 0;
};

/// Bytes of the UTF-8 character that starts the text; 0 if it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return overlong || no_character ? 0 : length;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
}

} // namespace

std::optional<Finding> unreadable(std::string_view text) {
  int line = 1;
  int column = 1;
  const auto found = [&](std::string message) { return Finding{line, column, std::move(message)}; };
  for (std::size_t i = 0; i < text.size();) { // bytes first: a rubbish file has no brackets worth speaking of
    const std::size_t length = character_length(text.substr(i));
    if (length == 0 || is_control(text[i]))
      return found(fmt::format("is not a text file: byte 0x{:02x} is no character of UTF-8 text", text[i] & 0xff));
    column = text[i] == '\n' ? 1 : column + 1;
    line += text[i] == '\n' ? 1 : 0;
    i += length;
  }
  Follower follower;
  line = 1;
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t next = follower.over(text, i);
    column = static_cast<int>(i - line_start) + 1;
    if (follower.too_deep()) return found(fmt::format("is nested deeper than {} levels", deepest));
    if (follower.too_dotted())
      return found(fmt::format("has more than {} dotted keys; write sections", max_dotted_keys));
    for (; i < next; ++i)
      if (text[i] == '\n') {
        ++line;
        line_start = i + 1;
      }
  }
  return std::nullopt;
}

std::string excerpt(std::string_view text, std::size_t most) {
  std::string shown;
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++characters) {
    if (characters == most) return shown + "...";
    const std::size_t length = character_length(text.substr(i));
    if (length == 0 || is_control(text[i]) || text[i] == '\n' || text[i] == '\r')
      shown += '?';
    else
      shown += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

} // namespace matrigrate
