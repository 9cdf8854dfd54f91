#pragma once

#include "fields/formula_tree.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

/// Numbers as formulas of named variables. Test: tests/unit/fields/expression_test.cpp
namespace matrigrate::fields {

/// A number that has a name in a formula.
struct NamedNumber {
  std::string name;
  double value = 0.0;
};

/// A formula that contains a name which nobody has defined.
struct UnknownName : std::invalid_argument {
  UnknownName(const std::string& why, std::string unknown) : std::invalid_argument(why), name(std::move(unknown)) {}

  std::string name;
};

/// A formula in variables and constants, such as "r_0*exp(-F/F_0)". It knows + - * / ^, comparisons, && || ! and ?:,
/// the functions and constants of muParser (sin, cos, exp, sqrt, abs, min, max, _pi ...), floor, ceil and mod. It has
/// no loops, no memory and no access to anything else. A comma stands between the arguments of a function only.
class Expression {
public:
  /// @param text       at most 1000 characters besides blanks
  /// @param variables  their names, in the order of the arguments of at()
  /// @throws UnknownName; std::invalid_argument saying what cannot be read, and at which character
  Expression(const std::string& text, std::span<const std::string_view> variables,
             std::span<const NamedNumber> constants = {});
  /// Of a tree, or of a part of one.
  Expression(FormulaTree tree, std::span<const std::string_view> variables,
             std::span<const NamedNumber> constants = {});
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&& other) noexcept;
  ~Expression();

  /// Its value; NaN or infinite where the formula is so. Not to be called by several threads at once.
  double at(std::span<const double> arguments) const;

  /// Whether the value may depend on a variable.
  bool uses(std::size_t variable) const;

  const FormulaTree& tree() const;

private:
  struct Parser;
  std::unique_ptr<Parser> m_parser;
};

/// A text as the formula that an Expression of the same names evaluates.
/// @param is_given  whether a name is one of a variable or constant
/// @throws FormulaFault; std::invalid_argument of a text that is too long
FormulaTree tree_of(std::string_view text, const std::function<bool(std::string_view)>& is_given);

/// Whether every formula knows the name: a function or a constant of muParser.
bool in_every_formula(const std::string& name);

} // namespace matrigrate::fields
