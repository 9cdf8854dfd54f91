#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The parts of a formula, with their places. The grammar is that of muParser, which evaluates; spellings of other
/// programs are read where their meaning is certain: a**b, pow(a, b), x², and, or, not, if(c, a, b), a typeset minus.
/// Test: tests/unit/fields/formula_tree_test.cpp
namespace matrigrate::fields {

/// A part of a formula.
struct Part {
  enum class Kind { number, name, prefix, infix, choice, call };

  Kind kind = Kind::number;
  std::string text;        ///< "0.5", "F", "-", "<=", "?", "exp"
  std::size_t at = 0;      ///< its first character in the text as typed, from 1
  std::vector<Part> parts; ///< operands, arguments; of a choice the condition and both values
};

/// A formula.
struct FormulaTree {
  Part whole;
  std::string chained; ///< what is wrong with the first of its chained comparisons, a < b < c; empty without any
};

/// Why a text is no formula.
struct FormulaFault : std::invalid_argument {
  FormulaFault(std::size_t place, const std::string& why, std::string unknown_name = {})
      : std::invalid_argument(why), at(place), unknown(std::move(unknown_name)) {}

  std::size_t at;      ///< the character, from 1
  std::string unknown; ///< the name that nobody has defined; empty of other faults, and where it is known what is meant
};

/// What a formula may name.
struct FormulaNames {
  std::function<bool(std::string_view)> is_number;   ///< variables and constants
  std::function<int(std::string_view)> arguments_of; ///< of a function: how many, -1 for one or more; 0: there is none
};

/// @throws FormulaFault
FormulaTree formula_tree(std::string_view text, const FormulaNames& names);

/// A part as a formula, with blanks and parentheses where they belong: what differs in them alone has the same text.
std::string written(const Part& part);

/// The same for the parser that evaluates: what && and || take is compared with 0 (it would make whole numbers of
/// constants), and !a is a == 0, which it lacks.
std::string for_evaluation(const Part& part);

bool is_comparison(const Part& part);

/// Calls visit(part) of all parts, the whole last.
template <class Visit>
void for_each_part(const Part& part, const Visit& visit) {
  for (const Part& of : part.parts) for_each_part(of, visit);
  visit(part);
}

} // namespace matrigrate::fields
