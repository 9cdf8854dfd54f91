#pragma once

#include "base/failure.hpp"
#include "parameters/fault_list.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Faults of one file while it is read. Test: tests/unit/study_plan/read_study_test.cpp
namespace matrigrate::study {

/// Where something stands.
struct Place {
  int line = 0;
  int column = 0;
};

Place place_of(const toml::node& node);
Place place_of(const toml::key& key);

/// "a", "b", ...: the first of many names.
std::string quoted_list(const std::vector<std::string>& names);

class FaultList {
public:
  using Hint = matrigrate::FaultList::Hint;

  explicit FaultList(std::string file) : m_faults(std::move(file)) {}

  const std::string& file() const { return m_faults.file(); }
  bool empty() const { return m_faults.empty(); }

  void add(Place place, std::string_view key, std::string message, Hint hint = {});
  void add(const std::vector<Fault>& faults);

  /// A fault for each key of a table that is none of these.
  void check_keys(const toml::table& table, std::string_view section, const std::vector<std::string>& keys,
                  const std::string& what = "there is no such key");
  /// What stands there; null, and a fault, if nothing does.
  /// @param remedy  behind "is missing": "; write error = 1.0"
  const toml::node* wanted(const toml::table& table, std::string_view section, std::string_view key,
                           const std::string& remedy = {});

  /// The value if it is of its type and range; otherwise a fault and the default.
  std::string text(const toml::node& node, std::string_view key);
  bool flag(const toml::node& node, std::string_view key);
  std::uint64_t whole(const toml::node& node, std::string_view key, std::uint64_t low, std::uint64_t high);
  /// A finite number; none with a fault.
  std::optional<double> number(const toml::node& node, std::string_view key);
  /// Index of the value among `names`; 0 with a fault.
  std::size_t choice(const toml::node& node, std::string_view key, const std::vector<std::string>& names);

  /// @throws ConfigurationError if there is any fault: faults of this file by line, then all others
  void raise() { m_faults.raise(); }

private:
  matrigrate::FaultList m_faults;
};

} // namespace matrigrate::study
