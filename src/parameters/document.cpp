#include "parameters/document.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "parameters/presets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdint>
#include <tuple>

namespace matrigrate {

namespace {

/// Whether a place lies behind the = of its line.
bool is_after_equals(std::string_view text, std::uint32_t line, std::uint32_t column) {
  for (; line > 1 && !text.empty(); --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, std::min<std::size_t>(column, text.find('\n'))).find('=') != std::string_view::npos;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
}

} // namespace

std::optional<Fault> fault_of_texts(const toml::node& node, const std::string& name) {
  if (const auto* table = node.as_table())
    for (const auto& [key, value] : *table)
      if (auto fault = fault_of_texts(value, name)) return fault;
  if (const auto* array = node.as_array())
    for (const toml::node& value : *array)
      if (auto fault = fault_of_texts(value, name)) return fault;
  const std::string text = node.value_or(std::string());
  const auto at = std::ranges::find_if(text, is_control);
  if (at == text.end()) return std::nullopt;
  const auto place = node.source().begin;
  return Fault{name, static_cast<int>(place.line), static_cast<int>(place.column), "",
               fmt::format("a text holds the control character U+{:04X}; programs would read what stands before "
                           "it alone, or differ in what they read",
                           static_cast<unsigned>(static_cast<unsigned char>(*at)))};
}

std::variant<toml::table, Fault> parse_document(std::string_view text, const std::string& name) {
  if (std::optional<Fault> fault = unreadable(text, name)) return *std::move(fault);
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

/// The end of a comment or string of a TOML text that begins at a place; of any other byte the next one. On a text that
/// is not valid TOML it agrees with a parser up to the first error, which is as far as the parser goes.
std::size_t end_of(std::string_view text, std::size_t at) {
  const char quote = text[at];
  if (quote == '#') return std::min(text.find('\n', at), text.size());
  if (quote != '"' && quote != '\'') return at + 1;
  const std::size_t closing = text.substr(at).starts_with(std::string(3, quote)) ? 3 : 1;
  std::size_t i = at + closing;
  while (i < text.size() && (closing == 3 || text[i] != '\n')) {
    const std::string_view ahead = text.substr(i, closing == 3 ? 5 : 1); // two may stand before the three that close
    const std::size_t quotes = std::min(ahead.find_first_not_of(quote), ahead.size());
    if (quotes >= closing) return i + quotes;
    const bool escapes = quote == '"' && text[i] == '\\' && text.substr(i + 1, 1) != "\n";
    i += escapes ? 2 : std::max<std::size_t>(quotes, 1);
  }
  return i;
}

} // namespace

std::optional<Fault> unreadable(std::string_view text, const std::string& name) {
  const auto fault_at = [&](std::size_t place, std::string message) {
    const std::string_view before = text.substr(0, place);
    const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80; };
    const std::string_view line = before.substr(before.rfind('\n') + 1); // npos + 1 is 0
    const auto characters = std::ssize(line) - std::ranges::count_if(line, goes_on);
    return Fault{name, static_cast<int>(std::ranges::count(before, '\n')) + 1, static_cast<int>(characters) + 1, "",
                 std::move(message)};
  };
  for (std::size_t i = 0; i < text.size();) { // bytes first: a rubbish file has no brackets worth speaking of
    const std::size_t length = character_length(text.substr(i));
    if (length == 0 || is_control(text[i]))
      return fault_at(i,
                      fmt::format("is not a text file: byte 0x{:02x} is no character of UTF-8 text", text[i] & 0xff));
    i += length;
  }
  int brackets = 0, dotted_keys = 0, dots = 0; // dots since the last character that ends a dotted key
  for (std::size_t i = 0; i < text.size(); i = end_of(text, i)) {
    const char c = text[i];
    if (c == '[' || c == '{') ++brackets;
    if (c == ']' || c == '}') brackets = std::max(0, brackets - 1);
    if (c == '.') ++dots;
    if (c == '=' && dots > 0) ++dotted_keys;
    if (std::string_view("[]{},=#\n").find(c) != std::string_view::npos) dots = 0;
    if (brackets > deepest || dots > deepest)
      return fault_at(i, fmt::format("is nested deeper than {} levels", deepest));
    if (dotted_keys > max_dotted_keys)
      return fault_at(i, fmt::format("has more than {} dotted keys; write sections", max_dotted_keys));
  }
  return std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
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

void FaultList::add(Fault fault, Hint hint) {
  if (!m_seen.insert(std::hash<std::string>{}(to_string(fault))).second) return;
  m_noted.push_back({std::move(fault), std::move(hint)});
  if (m_noted.size() > 4 * max_listed) sort_and_cut();
}

void FaultList::sort_and_cut() {
  const auto order = [&](const Noted& n) {
    return std::tuple(n.fault.file != m_file, n.fault.line > 0 ? n.fault.line : INT_MAX, n.fault.column);
  };
  std::ranges::stable_sort(m_noted, [&](const Noted& a, const Noted& b) { return order(a) < order(b); });
  if (m_noted.size() > max_listed) m_noted.erase(m_noted.begin() + max_listed, m_noted.end());
}

void FaultList::raise() {
  if (empty()) return;
  sort_and_cut();
  std::vector<Fault> faults;
  faults.reserve(m_noted.size() + 1);
  for (Noted& noted : m_noted) {
    if (noted.hint) noted.fault.message += noted.hint();
    faults.push_back(std::move(noted.fault));
  }
  if (m_seen.size() > faults.size())
    faults.push_back({m_file, 0, 0, "", fmt::format("has {} more faults", m_seen.size() - faults.size())});
  throw ConfigurationError(std::move(faults));
}

} // namespace matrigrate
