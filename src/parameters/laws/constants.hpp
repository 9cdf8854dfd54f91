#pragma once

#include "parameters/schema.hpp"

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

/// laws.constants: numbers of the user's own for the laws. Each is a parameter, such as laws.constants.F_s.
/// Test: tests/unit/parameters/constants_test.cpp
namespace matrigrate {

/// "F_s" of "laws.constants.F_s"; empty of any other path.
std::string_view constant_name(std::string_view path);

/// The constant of that name; null if there is none.
const LawConstant* find_constant(std::string_view name, const Parameters& p);

/// The value in the units of formulas.
double in_formulas(const LawConstant& constant);

/// "F_c = 0.05 nN", whatever the unit that was typed; fingerprints have it.
std::string text_of(const LawConstant& constant);
std::string constants_text(const Parameters& p);

/// The same as lines of a table of TOML, to be read back to the same bits, with the ranges.
std::string constants_table(const Parameters& p);

/// Reads all constants from one text, "F_c = 0.1 nN, n = 2".
/// @throws std::invalid_argument saying what is wrong
std::vector<LawConstant> constants_in(std::string_view text);

/// Gives a constant what stands at its name in a table: a value, or { value = "0.4 nN", range = ["0.1 nN", "1 nN"] }.
/// One that is not there, or is given a table, is defined by it.
/// @return what is wrong; empty if nothing is
std::string define_constant(std::string_view name, const toml::node& node, Parameters& p);

/// What is wrong with the path of a constant that is not there: which there are, and how one is defined.
std::string unknown_constant(std::string_view path, const Parameters& p);

} // namespace matrigrate
