#include "parameters/document.hpp"

#include "base/file.hpp"
#include "parameters/presets.hpp"
#include "parameters/scan.hpp"

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

} // namespace matrigrate
