#pragma once

#include "fields/formula_tree.hpp"
#include "parameters/units.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

/// Whether the units of a formula agree. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// The dimension of a name; none where it is a number without a unit, which may stand for any quantity.
using DimensionOf = std::function<std::optional<units::Dimension>(std::string_view)>;

/// The exponent of Pa, in thousandths, in the unit in which formulas have a quantity: of a stress, its inverse, a
/// viscosity; 0 of others, which are in nN, um and s.
int pascals_in(const units::Dimension& dimension);

/// What a quantity in internal units is multiplied by to be in the unit of formulas, where a stress is in Pa.
double formula_factor(const units::Dimension& dimension);

/// "nN", "1/s", "Pa s"; empty of a number.   @param pascals  pascals_in(), or another: "Pa um^2"
std::string formula_unit(const units::Dimension& dimension, int pascals);

/// What is wrong with the units of a formula: sums, comparisons, both values of a choice, arguments of min and max must
/// agree; arguments of exp and other functions, and exponents, are numbers; the whole is what is wanted. A number that
/// is written out fits everywhere, and so does what is multiplied with one. Pa um^2 and nN do not agree: 1 Pa is 1e-3
/// nN/um^2. Empty if nothing is.
std::string fault_of_units(const fields::Part& whole, const DimensionOf& of_name, const units::Dimension& wanted);

} // namespace matrigrate
