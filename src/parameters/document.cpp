#include "parameters/document.hpp"

#include "parameters/scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace matrigrate {

std::variant<toml::table, Fault> parse_document(std::string_view text, const std::string& name) {
  if (const auto finding = unreadable(text)) return Fault{name, finding->line, finding->column, "", finding->message};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte order mark is no character of the first line
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto place = error.source().begin;
    return Fault{name, static_cast<int>(place.line), static_cast<int>(place.column), "",
                 fmt::format("cannot be read as TOML: {}; text, and numbers with a unit, stand in quotes",
                             excerpt(error.description(), 200))};
  }
}

bool is_study(const toml::table& table) {
  constexpr std::array keys{"replicates", "sweep", "points", "latin_hypercube", "statistics"};
  return std::ranges::any_of(keys, [&](const char* key) { return table.contains(key); });
}

} // namespace matrigrate
