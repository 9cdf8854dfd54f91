#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The words of a formula, in the spelling of this program. Test: tests/unit/fields/formula_tree_test.cpp
namespace matrigrate::fields {

struct Word {
  enum class Kind { number, name, sign, end };

  Kind kind = Kind::end;
  std::string text;   ///< "0.5", "F", "<=", "("
  std::size_t at = 0; ///< its first character, from 1
  bool follows_blank = false;
};

/// The words of a text, and one of kind end.
/// @throws FormulaFault at a character that belongs to no formula
std::vector<Word> formula_words(std::string_view text);

/// How to write what other programs know by a name; empty if nothing is known of it.
std::string_view way_to_write(std::string_view name);

/// The name here of what other programs call otherwise: "asin" of arcsin and np.arcsin, "_pi" of pi; else the name
/// itself.
std::string name_here(std::string_view name);

} // namespace matrigrate::fields
