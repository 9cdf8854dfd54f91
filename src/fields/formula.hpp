#pragma once

#include "base/vector.hpp"
#include "fields/expression.hpp"

#include <string>

/// Numbers over the plane as formulas. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

/// An Expression in x and y [um], and r, the distance from the origin [um]: "200 + 50*sin(x/20)".
class Formula {
public:
  /// @throws std::invalid_argument saying what cannot be read, and where
  explicit Formula(const std::string& text);

  /// Its value at a point [um]; NaN or infinite where the formula is so. Not to be called by several threads at once.
  double at(const Vec2& x) const;

  /// As FormulaTree::chained.
  const std::string& chained() const { return m_expression.tree().chained; }

private:
  Expression m_expression;
};

} // namespace matrigrate::fields
