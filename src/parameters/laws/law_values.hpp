#pragma once

#include "fields/expression.hpp"
#include "parameters/schema.hpp"

#include <span>
#include <string>
#include <vector>

/// What the judgement of laws and the laws have in common. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// The numbers that a law names, written out or as parameters, and their negatives: where it may jump.
std::vector<double> law_numbers(const Row& law, const Parameters& p);

/// A text as a formula in the variables and names of a law.
/// @throws std::invalid_argument saying what is wrong, where, and which name may be meant
fields::Expression law_formula(const Row& law, const Parameters& p, const std::string& text);

/// What is wrong with the units of a law (law_units.hpp); empty if nothing is.
std::string law_unit_fault(const Row& law, const Parameters& p, const fields::Expression& formula);

/// The comparisons of a law that can be read which come out alike at all points of its grid: "angle < 90, at character
/// 1, holds wherever the law is judged (angle from -3.14159 to 3.14159 rad)".
std::vector<std::string> steady_comparisons(const Parameters& p, const Row& law);

/// "F = 0.3 nN, f_mat = 0.5".   @param named  which variables are told
std::string law_arguments(const Row& law, std::span<const double> arguments, const std::vector<bool>& named);

/// "is -2 1/s at F = 1 nN; allowed is >= 0 and <= 1e+06 1/s; ...": what is wrong with a value out of the law's range,
/// and what helps.
/// @param where  the arguments there
std::string law_fault(const Row& law, double value, const std::string& where);

} // namespace matrigrate
