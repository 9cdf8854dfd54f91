#include "base/csv_text.hpp"

#include <charconv>

namespace matrigrate {

namespace {

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// True if a spreadsheet would compute a field instead of showing it.
bool is_formula(std::string_view field) { return field.find_first_of("=+-@\t\r\n") == 0 && !is_number(field); }

} // namespace

std::string csv_text(std::string_view field) {
  std::string shown(is_formula(field) ? "'" : "");
  shown += field;
  if (shown.find_first_of(",\"\r\n") == std::string::npos) return shown;
  std::string out = "\"";
  for (const char c : shown) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

} // namespace matrigrate
