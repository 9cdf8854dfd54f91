#pragma once

#include "base/failure.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

/// Faults while files are read, at a cost that is linear in their number. Test:
/// tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

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
