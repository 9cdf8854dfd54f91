#pragma once

#include "base/failure.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace matrigrate {

// From the text of a file to its table. Test: tests/unit/parameters/hostile_test.cpp

/// The table of a TOML text, or the first thing that keeps it from being one: bytes that are no text, control
/// characters, nesting that is too deep, a syntax error. Takes a time linear in the length of the text.
/// @param name  the file, as it stands in the fault
std::variant<toml::table, Fault> parse_document(std::string_view text, const std::string& name);

/// The first text in a node that holds a control character other than a tab or the end of a line: a NUL, say, at which
/// what is written in C stops reading.
std::optional<Fault> fault_of_texts(const toml::node& node, const std::string& name);

/// The text of a file that is to be a table.
/// @throws ConfigurationError if it is larger than max_bytes   @throws InputOutputError if it cannot be read
std::string read_document(const std::filesystem::path& file, std::size_t max_bytes);

/// Whether a table is that of a study, which varies a scenario: it has replicates, or something to vary.
bool is_study(const toml::table& table);

/// The first thing for which a text is not given to the parser: bytes that are no text (control characters, invalid
/// UTF-8), brackets and dotted keys nested so deeply that a recursive parser would run out of stack, or more than
/// 50,000 dotted keys, among which the parser searches one by one.
std::optional<Fault> unreadable(std::string_view text, const std::string& name);

/// Without the blanks and tabs around it.
std::string_view trimmed(std::string_view text);

/// A piece of a file for a message: control characters replaced, cut to `most` characters.
std::string excerpt(std::string_view text, std::size_t most = 60);

/// @throws std::invalid_argument with a text as fmt::format makes it
template <class... Values>
[[noreturn]] void refuse(fmt::format_string<Values...> text, Values&&... values) {
  throw std::invalid_argument(fmt::format(text, std::forward<Values>(values)...));
}

// Faults while files are read, at a cost that is linear in their number. Test:
// tests/unit/parameters/parameters_test.cpp

/// Notes each fault once. The first 200 by place are kept, the others counted.
class FaultList {
public:
  static constexpr std::size_t max_listed = 200;

  /// Makes the end of a message that takes long to find, such as the nearest name; called for listed faults only.
  using Hint = std::function<std::string()>;

  /// @param file  its faults come first, by line; then those of other files
  explicit FaultList(std::string file) : m_file(std::move(file)) {}

  const std::string& file() const { return m_file; }
  bool empty() const { return m_noted.empty(); }
  void add(Fault fault, Hint hint = {});

  /// @throws ConfigurationError if there is any fault
  void raise();

private:
  struct Noted {
    Fault fault;
    Hint hint;
  };

  void sort_and_cut();

  std::string m_file;
  std::vector<Noted> m_noted;
  std::unordered_set<std::size_t> m_seen; ///< hashes of all faults
};

} // namespace matrigrate
