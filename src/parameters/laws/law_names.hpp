#pragma once

#include "fields/expression.hpp"
#include "parameters/laws/law_units.hpp"
#include "parameters/schema.hpp"

#include <optional>
#include <string>
#include <vector>

/// What formulas of laws may name besides their arguments, and what their texts mean. In formulas lengths are in um,
/// times in s, forces in nN, stresses in Pa. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// One of laws.constants.
struct LawConstant {
  fields::NamedNumber number;                ///< in the units of formulas
  std::optional<units::Dimension> dimension; ///< none of a plain number
  std::string text;                          ///< "F_c = 0.05 nN", whatever the unit that was typed
};

/// @throws std::invalid_argument saying what is wrong with laws.constants
std::vector<LawConstant> law_constants(const Parameters& p);

/// What is wrong with laws.constants; empty if nothing is.
std::string fault_of_constants(const Parameters& p);

/// Parameters by their symbol, "r_off,min" as r_off_min; F_both, the pull of both strands; the user's constants.
/// @throws std::invalid_argument as law_constants()
std::vector<fields::NamedNumber> law_names(const Parameters& p);

/// The dimension of each name of a law, as fault_of_units() asks for it.
/// @throws std::invalid_argument as law_constants()
DimensionOf law_dimensions(const Row& law, const Parameters& p);

/// What the text of a law, or of laws.constants, means, in one spelling: that of fields::written(), numbers by their
/// value; constants by name, each in the unit of formulas. A text that cannot be read stays as it is.
std::string law_meaning(const Row& row, const Parameters& p);

} // namespace matrigrate
