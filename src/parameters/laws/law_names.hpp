#pragma once

#include "fields/expression.hpp"
#include "parameters/schema.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What formulas of laws may name besides their arguments, and what their texts mean. In formulas lengths are in um,
/// times in s, forces in nN, stresses in Pa. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// Whom a name belongs to, "an argument of a law"; empty if to nobody.
std::string owner_of_name(std::string_view name);

/// Whether a constant may have the name though it belongs to somebody, to whom it did not in version 0.3.0.
bool came_later(std::string_view name);

/// Whether a law means the user's constant by a name of that kind: the laws of version 0.3.0 do. In the others the
/// constant comes last, and fault_of_law() refuses the name.
bool puts_constants_first(const Row& law);

/// Parameters by their symbol, "r_off,min" as r_off_min; F_both, the pull of both strands; the user's constants. Where
/// a name stands twice the first is meant.
std::vector<fields::NamedNumber> law_names(const Row& law, const Parameters& p);

/// The dimension of a name; none where it is a number without a unit, which may stand for any quantity.
using DimensionOf = std::function<std::optional<units::Dimension>(std::string_view)>;

/// The dimension of each name of a law, as fault_of_units() asks for it.
DimensionOf law_dimensions(const Row& law, const Parameters& p);

/// What the text of a law means, in one spelling: that of fields::written(), numbers by their value. A text that cannot
/// be read stays as it is.
std::string law_meaning(const Row& law, const Parameters& p);

// Whether the units of a formula agree.

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
