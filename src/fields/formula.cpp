#include "fields/formula.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace matrigrate::fields {

namespace {

constexpr std::array<std::string_view, 3> variables{"x", "y", "r"};

} // namespace

Formula::Formula(const std::string& text) : m_expression(text, variables) {}

double Formula::at(const Vec2& x) const { return m_expression.at(std::array{x.x(), x.y(), std::hypot(x.x(), x.y())}); }

} // namespace matrigrate::fields
