#include "tracks/table.hpp"

#include "base/text.hpp"
#include "tracks/layouts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace matrigrate::tracks {

namespace {

/// The characters 0x80 to 0x9f of Windows-1252; 0 where it has none.
constexpr std::array<std::uint16_t, 32> windows_1252{0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                                     0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                                     0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                                     0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};
constexpr std::uint32_t replacement = 0xfffd;

unsigned byte_at(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

void append(std::uint32_t c, std::string& text) {
  const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) {
    byte(0xc0 | (c >> 6U));
  } else {
    if (c < 0x10000) {
      byte(0xe0 | (c >> 12U));
    } else {
      byte(0xf0 | (c >> 18U));
      byte(0x80 | ((c >> 12U) & 0x3fU));
    }
    byte(0x80 | ((c >> 6U) & 0x3fU));
  }
  byte(0x80 | (c & 0x3fU));
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string from_windows_1252(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 8);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const unsigned c = byte_at(bytes, i);
    const std::uint32_t known = c >= 0x80 && c < 0xa0 ? windows_1252[c - 0x80] : c;
    append(known == 0 && c != 0 ? replacement : known, text);
  }
  return text;
}

std::string from_utf16(std::string_view bytes, bool big) {
  std::string text;
  const auto unit = [&](std::size_t i) {
    const unsigned a = byte_at(bytes, i), b = byte_at(bytes, i + 1);
    return big ? a << 8U | b : b << 8U | a;
  };
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const std::uint32_t c = unit(i);
    if (c < 0xd800 || c > 0xdfff) {
      append(c, text);
      continue;
    }
    const std::uint32_t low = c < 0xdc00 && i + 3 < bytes.size() ? unit(i + 2) : 0;
    if (low >= 0xdc00 && low <= 0xdfff) {
      append(0x10000 + ((c - 0xd800) << 10U) + (low - 0xdc00), text);
      i += 2;
    } else {
      append(replacement, text);
    }
  }
  return text;
}

/// Minus signs and dashes become "-", blanks that do not break become " ", and marks of a byte order within a text
/// nothing.
void mend_signs(std::string& text) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view three = std::string_view(text).substr(i, 3);
    const unsigned last = three.size() == 3 ? byte_at(three, 2) : 0;
    const bool general = three.starts_with("\xe2\x80");
    if (three == "\u2212" || (general && last >= 0x90 && last <= 0x95)) {
      text[to++] = '-';
      i += 2;
    } else if (general && (last == 0x87 || last == 0x89 || last == 0xaf)) {
      text[to++] = ' ';
      i += 2;
    } else if (three.starts_with("\u00a0")) {
      text[to++] = ' ';
      i += 1;
    } else if (three == "\ufeff") {
      i += 2;
    } else {
      text[to++] = text[i];
    }
  }
  text.resize(to);
}

/// \r\n and \r become \n.
void mend_line_ends(std::string& text) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    text[to++] = text[i] == '\r' ? '\n' : text[i];
  }
  text.resize(to);
}

/// Why a file is no text, by its first bytes; empty if it may be one.
std::string other_kind(std::string_view bytes) {
  if (bytes.starts_with("PK\x03\x04")) return "is a workbook (.xlsx) or another archive: save the sheet as CSV";
  if (bytes.starts_with("\xd0\xcf\x11\xe0")) return "is a workbook (.xls): save the sheet as CSV";
  if (bytes.starts_with("\x1f\x8b")) return "is compressed (gzip): unpack it";
  if (bytes.starts_with("\x89HDF")) return "is an HDF5 file: export the tracks as CSV";
  return {};
}

void find_control_characters(std::string_view text, Findings& findings) {
  std::size_t line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if ((static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) || c == '\n' || c == '\t' || c == '\f' || c == '\v')
      continue;
    return findings.fault(line, c == '\0' ? "is no text, or UTF-16 without its mark: save it as CSV in UTF-8"
                                          : "has a control character: is it a text?");
  }
}

} // namespace

Text decoded(std::string_view bytes, Findings& findings) {
  Text text{.utf8 = {}, .encoding = "UTF-8"};
  if (const std::string why = other_kind(bytes); !why.empty()) {
    findings.fault(0, why);
    return text;
  }
  const bool little = bytes.starts_with("\xff\xfe");
  if (little || bytes.starts_with("\xfe\xff")) {
    text = {.utf8 = from_utf16(bytes.substr(2), !little), .encoding = "UTF-16"};
  } else {
    if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
    if (is_utf8(bytes)) {
      text.utf8 = bytes;
    } else {
      text = {.utf8 = from_windows_1252(bytes), .encoding = "Windows-1252"};
      findings.note("the file is not UTF-8; it is read as Windows-1252");
    }
  }
  mend_line_ends(text.utf8);
  mend_signs(text.utf8);
  find_control_characters(text.utf8, findings);
  return text;
}

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
