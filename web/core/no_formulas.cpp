// In place of src/fields/expression.cpp: muParser is not there in WebAssembly.
#include "fields/expression.hpp"

#include <utility>

namespace matrigrate::fields {

struct Expression::Parser {};

Expression::Expression(const std::string& text, std::span<const std::string_view> /*variables*/,
                       std::span<const NamedNumber> /*constants*/) {
  throw std::invalid_argument("is a formula, \"" + text.substr(0, 80)
                              + "\"; formulas are not available in the live page: draw the field, or run the scenario "
                                "with the program");
}

Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&& other) noexcept {
  m_parser = std::move(other.m_parser);
  return *this;
}
Expression::~Expression() = default;

double Expression::at(std::span<const double> /*arguments*/) const { return 0.0; } // there is none to ask

bool Expression::uses(std::size_t /*variable*/) const { return false; }

bool in_every_formula(const std::string& /*name*/) { return false; }

} // namespace matrigrate::fields
