#include "parameters/document.hpp"

#include "base/file.hpp"
#include "parameters/presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace matrigrate {

namespace {

/// Whether a place lies behind the = of its line.
bool is_after_equals(std::string_view text, std::uint32_t line, std::uint32_t column) {
  for (; line > 1 && !text.empty(); --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, std::min<std::size_t>(column, text.find('\n'))).find('=') != std::string_view::npos;
}

bool is_control_character(char c) {
  const auto code = static_cast<unsigned char>(c);
  return (code < 0x20 && c != '\t' && c != '\n' && c != '\r') || code == 0x7f;
}

} // namespace

std::optional<Fault> fault_of_texts(const toml::node& node, const std::string& name) {
  std::optional<Fault> found;
  if (const auto* text = node.as_string()) {
    const auto at = std::ranges::find_if(text->get(), is_control_character);
    if (at != text->get().end()) {
      const auto place = node.source().begin;
      found = Fault{name, static_cast<int>(place.line), static_cast<int>(place.column), "",
                    fmt::format("a text holds the control character U+{:04X}; programs would read what stands before "
                                "it alone, or differ in what they read",
                                static_cast<unsigned>(static_cast<unsigned char>(*at)))};
    }
  } else if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      if (!found) found = fault_of_texts(value, name);
  } else if (const auto* array = node.as_array()) {
    for (const toml::node& value : *array)
      if (!found) found = fault_of_texts(value, name);
  }
  return found;
}

std::variant<toml::table, Fault> parse_document(std::string_view text, const std::string& name) {
  if (const auto finding = unreadable(text)) return Fault{name, finding->line, finding->column, "", finding->message};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte order mark is no character of the first line
  try {
    toml::table table = toml::parse(text);
    if (std::optional<Fault> fault = fault_of_texts(table, name)) return std::move(*fault);
    return table;
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    const bool in_value = is_after_equals(text, place.line, place.column);
    return Fault{name, static_cast<int>(place.line), static_cast<int>(place.column), "",
                 fmt::format("cannot be read as TOML: {}{}", excerpt(error.description(), 200),
                             in_value ? "; text, and numbers with a unit, stand in quotes" : "")};
  }
}

std::string read_document(const std::filesystem::path& file, std::size_t max_bytes) {
  std::error_code unknown_size; // of folders, devices and missing files, which read_file() refuses
  const std::uintmax_t size = std::filesystem::file_size(file, unknown_size);
  if (!unknown_size && size > max_bytes)
    throw ConfigurationError(
        {Fault{file.string(), 0, 0, "", fmt::format("has {} bytes, more than the {} allowed", size, max_bytes)}});
  if (!std::filesystem::exists(file, unknown_size) && find_preset(file.string()) != nullptr)
    throw InputOutputError(fmt::format("{0}: there is no such file, but a preset of this name; it becomes a file by "
                                       "matrigrate new {0}.toml --preset {0}",
                                       file.string()));
  return read_file(file, max_bytes);
}

bool is_study(const toml::table& table) {
  constexpr std::array keys{"replicates", "sweep", "points",     "latin_hypercube", "one_at_a_time",
                            "morris",     "steps", "conditions", "targets",         "statistics"};
  return std::ranges::any_of(keys, [&](const char* key) { return table.contains(key); });
}

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
