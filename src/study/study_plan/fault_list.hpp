#pragma once

#include "base/failure.hpp"
#include "parameters/document.hpp"

#include <toml++/toml.h>

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Faults of one file while it is read. Test: tests/unit/study_plan/read_study_test.cpp
namespace matrigrate::study {

/// Where something stands.
struct Place {
  int line = 0;
  int column = 0;

  Place() = default;
  Place(const toml::node& node) : Place(node.source()) {} // NOLINT: a fault may name a node as its place
  Place(const toml::key& key) : Place(key.source()) {}    // NOLINT: the same
  explicit Place(const toml::source_region& source)
      : line(static_cast<int>(source.begin.line)), column(static_cast<int>(source.begin.column)) {}

  auto operator<=>(const Place&) const = default; // NOLINT: no null pointer, but the 0 of a comparison
};

/// The table of a TOML text.   @throws ConfigurationError with one fault if it is none
toml::table table_of(std::string_view text, const std::string& name);

/// "a", "b", ...: the first of many names.
std::string quoted_list(const std::vector<std::string>& names);

class FaultList : public matrigrate::FaultList {
public:
  using matrigrate::FaultList::add;
  using matrigrate::FaultList::FaultList;

  void add(Place place, std::string_view key, std::string message, Hint hint = {});
  void add(const std::vector<Fault>& faults);

  /// A fault for each key of a table that is none of these.
  void check_keys(const toml::table& table, std::string_view section, const std::vector<std::string>& keys,
                  const std::string& what = "there is no such key");
  /// What stands there; null, and a fault, if nothing does.
  /// @param remedy  behind "is missing": "; write error = 1.0"
  const toml::node* wanted(const toml::table& table, std::string_view section, std::string_view key,
                           const std::string& remedy = {});

  /// The table that stands there; null, and a fault, if it is none.
  const toml::table* table(const toml::node& node, std::string_view key, std::string_view expected = "table");

  /// The value if it is of its type and range; otherwise a fault and the default.
  std::string text(const toml::node& node, std::string_view key);
  bool flag(const toml::node& node, std::string_view key);
  std::uint64_t whole(const toml::node& node, std::string_view key, std::uint64_t low, std::uint64_t high);
  /// A finite number; none with a fault.
  std::optional<double> number(const toml::node& node, std::string_view key);
  /// Index of the value among `names`; 0 with a fault.
  std::size_t choice(const toml::node& node, std::string_view key, const std::vector<std::string>& names);
};

} // namespace matrigrate::study
