#pragma once

#include "parameters/rules.hpp"
#include "parameters/schema.hpp"

#include <string>
#include <vector>

/// Laws judged over the ranges of their arguments, on a grid. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// Why no run begins with a law that can be read: it compares three values at once, its units do not agree, or a value
/// is not allowed between the bounds of its arguments (with these, and the place in the formula). Empty if nothing is
/// wrong.
std::string fault_of_law_values(const Parameters& p, const Row& law);

/// One for each law that may differ from the default: its values are allowed.
std::vector<Rule> rules_of_law_values();

/// What the values of a law may depend on.
std::vector<std::string_view> keys_of_law(const Row& law);

/// The rule that the values of a law, or of a field, are allowed.
std::string values_rule(const Row& row);

/// The comparisons of a law that can be read which come out alike at all points of its grid: "angle < 90, at character
/// 1, holds wherever the law is judged (angle from -3.14159 to 3.14159 rad)".
std::vector<std::string> steady_comparisons(const Parameters& p, const Row& law);

/// The numbers that a law names, written out or as parameters, and their negatives: where it may jump.
std::vector<double> law_numbers(const Row& law, const Parameters& p);

} // namespace matrigrate
