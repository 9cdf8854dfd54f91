// In place of src/fields/formula.cpp: muParser is not there in WebAssembly.
#include "fields/formula.hpp"

#include <stdexcept>

namespace matrigrate::fields {

struct Formula::Parser {};

Formula::Formula(const std::string& text) {
  throw std::invalid_argument("is a formula, \"" + text.substr(0, 80)
                              + "\"; formulas are not available in the live page: draw the field, or run the scenario "
                                "with the program");
}

Formula::Formula(Formula&&) noexcept = default;
Formula::~Formula() = default;

double Formula::at(const Vec2& /*x*/) const { return 0.0; } // there is none to ask

} // namespace matrigrate::fields
