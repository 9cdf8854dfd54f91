#pragma once

#include "parameters/parameters.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What parameters must fulfil together. Test: tests/unit/parameters/schema_test.cpp, read_test.cpp
namespace matrigrate {

/// A condition on several parameters.
struct Rule {
  std::string_view name;
  /// All parameters that it depends on; the first one set on the command line, else in the file, is blamed.
  std::vector<std::string_view> keys;
  std::function<std::string(const Parameters&)>
      broken; ///< what is wrong and what is allowed; empty where the rule holds
  std::function<bool(const Parameters&)> matters = {}; ///< whether it can be broken, found quickly; empty: always
  bool is_of_first = false; ///< what is wrong is its first key, which is blamed if it is given, and named if it is not
};

/// What is wrong, said of the key that is blamed.
std::string said_of(const Rule& rule, std::string_view blamed, const std::string& broken);

std::span<const Rule> rules();

/// Whether the rules on the lattice of the matrix hold. Where they do not, rules that compute on the lattice could take
/// minutes, and would judge what no run can have.
bool has_lattice(const Parameters& p);

/// What is wrong with the start of one of several cells.
struct CellFault {
  std::size_t cell = 0; ///< index into Parameters::cells
  std::string message;
};

/// Cells that reach the clamped rim or lie outside of the disc, and cells that lie closer than the range of their
/// repulsion: one fault for each cell, and for each pair at the later one. None without Parameters::cells.
std::vector<CellFault> cell_faults(const Parameters& p);

/// The rule that tells the first of cell_faults().
inline constexpr std::string_view several_cells_rule = "several cells have room";

} // namespace matrigrate
