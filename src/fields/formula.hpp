#pragma once

#include "base/vector.hpp"

#include <memory>
#include <string>

/// Numbers over the plane as formulas. Test: tests/unit/fields/fields_test.cpp
namespace matrigrate::fields {

/// A formula in x and y [um], such as "200 + 50*sin(x/20)". It knows + - * / ^, comparisons, && || and ?:, the
/// functions and constants of muParser (sin, cos, exp, sqrt, abs, min, max, _pi ...), and r, the distance from the
/// origin [um]. It has no loops, no memory and no access to anything else. A comma stands between the
/// arguments of a function only.
class Formula {
public:
  /// @param text  at most 1000 characters
  /// @throws std::invalid_argument saying what cannot be read, and where
  explicit Formula(const std::string& text);
  Formula(Formula&&) noexcept;
  ~Formula();

  /// Its value at a point [um]; NaN or infinite where the formula is so. Not to be called by several threads at once.
  double at(const Vec2& x) const;

private:
  struct Parser;
  std::unique_ptr<Parser> m_parser;
};

} // namespace matrigrate::fields
