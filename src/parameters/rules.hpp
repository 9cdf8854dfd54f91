#pragma once

#include "parameters/schema.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What parameters must fulfil together. Test: tests/unit/parameters/schema_test.cpp, read_test.cpp
namespace matrigrate {

/// A condition on several parameters.
struct Rule {
  std::string name;
  /// All parameters that it depends on; the first one set on the command line, else in the file, is blamed.
  std::vector<std::string_view> keys;
  std::function<std::string(const Parameters&)>
      broken;                          ///< what is wrong and what is allowed; empty where the rule holds
  std::vector<std::string> after = {}; ///< names of rules that it rests on: where one is broken, it is not judged
  std::function<bool(const Parameters&)> matters = {}; ///< whether it can be broken, found quickly; empty: always
  bool is_of_first = false; ///< what is wrong is its first key, which is blamed if it is given, and named if it is not
};

/// Rules judged one after the other, each after those that it rests on.
class Judgement {
public:
  /// What is wrong, found by judge(rule); empty where the rule holds, does not matter, or rests on a broken one.
  template <class Judge>
  std::string operator()(const Rule& rule, const Parameters& p, const Judge& judge) {
    const auto is_broken = [&](const std::string& name) { return m_broken.contains(name); };
    const bool rests_on_broken = std::ranges::any_of(rule.after, is_broken);
    if (!rests_on_broken && rule.matters && !rule.matters(p)) return {};
    std::string fault = rests_on_broken ? std::string() : judge(rule);
    if (rests_on_broken || !fault.empty()) m_broken.insert(rule.name);
    return fault;
  }

private:
  std::set<std::string, std::less<>> m_broken; ///< and those that rest on them
};

/// What is wrong, said of the key that is blamed.
std::string said_of(const Rule& rule, std::string_view blamed, const std::string& broken);

std::span<const Rule> rules();

/// The rules on the lattice of the matrix. Where one is broken, rules that compute on the lattice could take minutes,
/// and would judge what no run can have.
std::vector<std::string> lattice_rules();

/// The rule that the text of a law can be read.
std::string readable_rule(const Row& law);

/// What is wrong with the start of one of several cells.
struct CellFault {
  std::size_t cell = 0; ///< index into Parameters::cells
  std::string message;
};

/// Cells that reach the clamped rim or lie outside of the disc, and cells that lie closer than the range of their
/// repulsion: one fault for each cell, and for each pair at the later one. None without Parameters::cells.
std::vector<CellFault> cell_faults(const Parameters& p);

/// The rule that tells the first of cell_faults().
inline constexpr const char* several_cells_rule = "several cells have room";

} // namespace matrigrate
