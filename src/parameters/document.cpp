#include "parameters/document.hpp"

#include "parameters/nearest.hpp"
#include "parameters/scan.hpp"
#include "parameters/schema.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace matrigrate {

namespace {

constexpr int most_attempts = 50;

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The dotted name that starts the text, if it is made of bare keys.
std::string leading_name(std::string_view text) {
  text = trimmed(text);
  std::size_t length = 0;
  while (length < text.size()
         && std::string_view("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.").find(text[length])
                != std::string_view::npos)
    ++length;
  const std::string name(text.substr(0, length));
  const bool dotted = name.find("..") == std::string::npos && !name.starts_with('.') && !name.ends_with('.');
  return dotted ? name : std::string();
}

/// The lines of a text, which can be taken out one by one.
class Lines {
public:
  explicit Lines(std::string_view text) {
    while (true) {
      const std::size_t end = text.find('\n');
      m_lines.emplace_back(text.substr(0, end));
      if (end == std::string_view::npos) break;
      text.remove_prefix(end + 1);
    }
    look_over();
  }

  std::string text() const { return fmt::format("{}", fmt::join(m_lines, "\n")); }
  std::size_t size() const { return m_lines.size(); }
  bool is_header(std::size_t i) const { return m_first[i] == i && trimmed(m_lines[i]).starts_with('['); }
  std::size_t first(std::size_t i) const { return m_first[i]; } ///< where the value that line i continues was begun

  /// Whether line i would assign, were it not inside a bracket or string that was left open before it.
  bool swallowed(std::size_t i) const {
    return m_first[i] < i && (m_lines[i].find('=') != std::string::npos || trimmed(m_lines[i]).empty());
  }
  const std::string& key(std::size_t i) const { return m_keys[m_first[i]]; }

  /// The line (from 0) on which the same key or header stood first; i if it did not.
  std::size_t first_of_key(std::size_t i) const {
    for (std::size_t j = 0; j < i; ++j)
      if (is_header(j) == is_header(i) && m_keys[j] == m_keys[i]) return j;
    return i;
  }

  /// Takes out what was wrong at line i, with the lines before it that belong to the same value.
  void take_out(std::size_t i) {
    const std::size_t first = m_first[i];
    const bool replaced = m_lines[first].starts_with("[matrigrate-");
    if (is_header(first) && !replaced)
      replace_header(first);
    else {
      const std::size_t end = swallowed(i) ? first + 1 : i + 1;
      for (std::size_t j = first; j < end; ++j) m_lines[j].clear();
    }
    look_over();
  }

private:
  static std::string header_name(std::string_view line) {
    line = trimmed(line);
    while (line.starts_with('[')) line.remove_prefix(1);
    const std::string name = leading_name(line);
    return name.starts_with(repeated_section) ? name.substr(std::min(name.size(), name.find('.') + 1)) : name;
  }

  void look_over() {
    m_first = first_lines(text());
    m_keys.clear();
    std::string section;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
      if (is_header(i)) {
        section = header_name(m_lines[i]);
        m_keys.push_back(section);
        continue;
      }
      const std::string key = m_first[i] == i ? leading_name(m_lines[i]) : std::string();
      m_keys.push_back(key.empty() || section.empty() ? key : fmt::format("{}.{}", section, key));
    }
  }

  void replace_header(std::size_t i) {
    const std::string name = header_name(m_lines[i]);
    m_lines[i] =
        name.empty() ? fmt::format("[{}{}]", unread_section, i) : fmt::format("[{}{}.{}]", repeated_section, i, name);
  }

  std::vector<std::string> m_lines;
  std::vector<std::size_t> m_first;
  std::vector<std::string> m_keys; ///< dotted path of the key or header of each line, empty where there is none
};

/// What the parser says, in the words of the other faults.
std::string message_of(std::string_view description, const Lines& lines, std::size_t line) {
  if (description.find("cannot redefine existing") != std::string_view::npos) {
    const std::size_t first = lines.first_of_key(line);
    const std::string where = first == line ? "" : fmt::format(" (first on line {})", first + 1);
    return fmt::format("is given twice{}", where);
  }
  if (description.find("unescaped control characters") != std::string_view::npos) // the end of the line, then
    description = "the closing quote is missing";
  const std::size_t colon = description.find(": ");
  if (description.starts_with("Error while parsing ") && colon != std::string_view::npos)
    description.remove_prefix(colon + 2);
  const Row* row = find_row(lines.key(line));
  const std::string example =
      row == nullptr ? "" : fmt::format("; write it like {} = {}", key_of(*row), value_text(*row, {}));
  return fmt::format("cannot be read: {}{}", excerpt(description, 200), example);
}

} // namespace

Document parse_document(std::string_view text, const std::string& name) {
  Document document;
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte order mark is no character of the first line
  Lines lines(text);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    try {
      document.table = toml::parse(lines.text());
      return document;
    } catch (const toml::parse_error& error) {
      const auto place = error.source().begin;
      std::size_t line = std::clamp<std::size_t>(place.line, 1, lines.size()) - 1;
      const bool unfinished =
          lines.swallowed(line) || error.description().find("end-of-file") != std::string_view::npos;
      if (unfinished) line = lines.first(line); // where it was begun tells more than where something else was found
      const std::string message = message_of(error.description(), lines, line);
      const int column = unfinished ? 1 : static_cast<int>(place.column);
      document.faults.push_back({name, static_cast<int>(line) + 1, column, excerpt(lines.key(line), 80), message});
      lines.take_out(line);
    }
  }
  document.faults.push_back({name, 0, 0, "", "has more errors; correct these first"});
  return document;
}

} // namespace matrigrate
