#pragma once

#include <string_view>

/// Units in the names of columns. Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate::units {

/// What the numbers of a column are multiplied by to be in the wanted unit; 1 if its name states none. A name states a
/// unit behind its last _ ("E_kPa"), or in brackets at its end ("E (kPa)", "E [kPa]"). A single letter behind _ is
/// none, but a part of the name ("E_s").
/// @throws std::invalid_argument if it states a unit of another dimension, or one with wrong capital letters
double factor_of_column(std::string_view name, std::string_view wanted);

} // namespace matrigrate::units
