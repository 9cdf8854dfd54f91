#pragma once

#include "fields/expression.hpp"
#include "parameters/laws/law_units.hpp"
#include "parameters/schema.hpp"

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

/// The dimension of each name of a law, as fault_of_units() asks for it.
DimensionOf law_dimensions(const Row& law, const Parameters& p);

/// What the text of a law means, in one spelling: that of fields::written(), numbers by their value. A text that cannot
/// be read stays as it is.
std::string law_meaning(const Row& law, const Parameters& p);

} // namespace matrigrate
