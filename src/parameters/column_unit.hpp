#pragma once

#include <string_view>

/// Units in the names of columns. Test: tests/unit/parameters/column_unit_test.cpp
namespace matrigrate::units {

/// The unit that the name of a column states: behind its last _ ("E_kPa"), or in brackets at its end ("E (kPa)", "E
/// [kPa]"); empty if nothing there is a unit. A single letter behind _ is none, but a part of the name ("E_s").
std::string_view unit_of_column(std::string_view name);

/// What the numbers of a column are multiplied by to be in the wanted unit; 1 if its name states none.
/// @throws std::invalid_argument if it states a unit of another dimension, or one with wrong capital letters
double factor_of_column(std::string_view name, std::string_view wanted);

} // namespace matrigrate::units
