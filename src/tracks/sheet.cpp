#include "tracks/table.hpp"

#include "tracks/layouts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace matrigrate::tracks {

namespace {

/// Reads rows from a text, one after the other.
class RowReader {
public:
  RowReader(std::string_view text, char separator) : m_text(text), m_separator(separator) {}

  bool at_end() const { return m_at >= m_text.size(); }

  SheetRow next() {
    SheetRow row{.line = m_line, .fields = {}};
    skip_blanks();
    do row.fields.push_back(field(row));
    while (over_separator());
    if (!at_end()) { // over the end of the line
      ++m_at;
      ++m_line;
    }
    return row;
  }

private:
  bool by_blanks() const { return m_separator == ' '; }
  bool is_separator(char c) const { return c == m_separator || (by_blanks() && c == '\t'); }

  void skip_blanks() {
    while (!at_end() && (m_text[m_at] == ' ' || m_text[m_at] == '\t') && (by_blanks() || !is_separator(m_text[m_at])))
      ++m_at;
  }

  bool over_separator() {
    if (at_end() || m_text[m_at] == '\n') return false;
    ++m_at;
    if (!by_blanks()) return true;
    skip_blanks();
    return !at_end() && m_text[m_at] != '\n';
  }

  std::string field(SheetRow& row) {
    skip_blanks();
    std::string text;
    if (!at_end() && m_text[m_at] == '"') quoted(text, row);
    while (!at_end() && m_text[m_at] != '\n' && !is_separator(m_text[m_at])) text += m_text[m_at++];
    return std::string(trimmed(text));
  }

  void quoted(std::string& text, SheetRow& row) {
    for (++m_at; !at_end(); ++m_at) {
      const char c = m_text[m_at];
      if (c == '"' && m_text.substr(m_at + 1).starts_with('"')) {
        ++m_at;
      } else if (c == '"') {
        ++m_at;
        return;
      }
      if (c == '\n') ++m_line;
      text += c;
    }
    row.open_quote = true;
  }

  std::string_view m_text;
  char m_separator;
  std::size_t m_at = 0;
  std::size_t m_line = 1;
};

} // namespace

const std::string& SheetRow::field(std::optional<std::size_t> column) const {
  static const std::string none;
  return column && *column < fields.size() ? fields[*column] : none;
}

std::vector<SheetRow> sheet_rows(std::string_view text, char separator, std::size_t most) {
  std::vector<SheetRow> rows;
  RowReader reader(text, separator);
  while (!reader.at_end() && rows.size() < most) {
    SheetRow row = reader.next();
    if (std::ranges::any_of(row.fields, [](const std::string& field) { return !field.empty(); }))
      rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<char> named_separator(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string first = lower(trimmed(text.substr(0, end)));
  std::erase(first, '"');
  if (!first.starts_with("sep=") || first.size() > 5) return std::nullopt;
  if (end != std::string_view::npos) text = text.substr(end); // its end of line stays, and with it the number of lines
  return first.size() == 5 ? first[4] : '\t';                 // a tab is trimmed away
}

std::optional<double> sheet_number(std::string_view field, bool comma) {
  std::string text(trimmed(field));
  if (text.starts_with('+') && !text.starts_with("+-")) text.erase(0, 1);
  if (comma) {
    if (text.find('.') != std::string::npos) return std::nullopt;
    std::ranges::replace(text, ',', '.');
  }
  const std::string_view digits = std::string_view(text).substr(text.starts_with('-') ? 1 : 0);
  if (digits.empty() || (digits[0] != '.' && (digits[0] < '0' || digits[0] > '9'))) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool has_thousands_sign(std::string_view field) {
  std::string_view text = trimmed(field);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t at = text.find_first_of(".,' ");
  if (at == 0 || at > 3) return false; // or not found
  const char sign = text[at];
  std::string digits(text.substr(0, at));
  text.remove_prefix(at);
  for (; text.size() >= 4 && text.front() == sign; text.remove_prefix(4)) digits += text.substr(1, 3);
  if (!text.empty() && text.front() != sign && (text.front() == '.' || text.front() == ',')) {
    text.remove_prefix(1);
    digits += text;
    text = {};
  }
  return text.empty() && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

bool says_nothing(std::string_view field) {
  static const std::vector<std::string> words{"",     "nan", "na",   "n/a",  "#n/a",     "none",
                                              "null", "-",   "<na>", "-nan", "undefined"};
  return std::ranges::find(words, lower(trimmed(field))) != words.end();
}

bool is_no_track(std::string_view id) {
  static const std::vector<std::string> words{"no track", "untracked", "unassigned", "unlinked"};
  return says_nothing(id) || sheet_number(id, false).value_or(0.0) < 0.0
         || std::ranges::find(words, lower(id)) != words.end();
}

std::optional<std::string_view> behind_comment_sign(std::string_view text) {
  for (const std::string_view sign : {"#", "%", "//", ";"})
    if (text.starts_with(sign)) return trimmed(text.substr(sign.size()));
  return std::nullopt;
}

} // namespace matrigrate::tracks
