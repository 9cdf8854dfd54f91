#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace matrigrate::units {

// Quantities with their units, and the internal coherent set um, s, nN (stress kPa, viscosity nN s/um^2 = 1000 Pa s).
// A number is converted as decimal text wherever its unit is a power of ten away from the internal one: the exponent
// is shifted and the digits are read once, so that "200 Pa" has the bits of 0.2 and "0.7 Pa" those of 0.0007.
// Test: tests/unit/parameters/units_test.cpp

/// Exponents of length, time, force and angle, in thousandths: a stress is {-2000, 0, 1000}.
struct Dimension {
  int length = 0;
  int time = 0;
  int force = 0;
  int angle = 0;

  bool operator==(const Dimension&) const = default;
};

/// "a stress", "a length"..., or "um^0.5 s" where there is no word for it.
std::string to_string(const Dimension& dimension);

/// A unit is 2^a 3^b 10^c pi^d of the internal unit of its dimension, with exponents in thousandths (um^0.5 is rational
/// in them, and so is an hour: 2^2 3^2 10^2 s).
struct Unit {
  Dimension dimension;
  int two = 0;
  int three = 0;
  int ten = 0;
  int pi = 0;

  /// Whether a conversion from it only shifts the decimal point.
  bool decimal() const { return two == 0 && three == 0 && pi == 0 && ten % 1000 == 0; }
};

/// Why a text is no number with a unit.
struct Unreadable : std::invalid_argument {
  Unreadable(const std::string& why, bool part, bool advice)
      : std::invalid_argument(why), names_part(part), advises(advice) {}

  bool names_part; ///< it begins with the part of the text that it is about
  bool advises;    ///< it ends with what may be meant
};

/// Reads a product of powers, left to right: "Pa", "nN s/um^2", "N/m^1.5", "1/s", "kg/m^3"; "1" or nothing is a ratio.
/// Symbols: m, g, s, N, Pa with the SI prefixes p n u (or µ) m k M G, cm; times also in words ("min", "minutes", "h",
/// "hours", "d", "days"); angles: rad, deg, °, degrees.
/// @throws std::invalid_argument saying what cannot be read, Unreadable where there is more to say of it
Unit parse_unit(std::string_view text);

/// a/b.
Unit quotient(const Unit& a, const Unit& b);

/// A decimal number as typed, and what follows it.
struct Quantity {
  std::string number; ///< text of a finite decimal: "-1.5e-3"
  std::string unit;   ///< may be empty
};

/// Splits "1e-3 N/m" into its number and its unit. Times may be added up: "6 h 30 min" is 23400 s.
/// @throws std::invalid_argument if it does not start with a number; Unreadable if it has a decimal comma
Quantity parse_quantity(std::string_view text);

/// @param number  text of a decimal, as in Quantity
/// @return its value in internal units; correctly rounded if unit.decimal()
/// @throws std::invalid_argument if no double can hold it
double to_internal(std::string_view number, const Unit& unit);
double to_internal(double number, const Unit& unit);

/// @param value  in internal units, finite
/// @return the shortest decimal that to_internal reads back, in this unit, to the same bits; empty if there is none of
///         reasonable length (never if unit.decimal())
std::string from_internal(double value, const Unit& unit);

/// The same as a number; to the nearest double where there is no such decimal (22 min in h).
double number_in(double value, const Unit& unit);

/// "; did you mean kPa?" of "kpa"; empty if no unit has these letters, nor these as its name. Where several have, the
/// most common one is meant. Test: tests/unit/parameters/units_test.cpp
std::string unit_meant(std::string_view text);

// Units in the names of columns. Test: tests/unit/parameters/parameters_test.cpp

/// What the numbers of a column are multiplied by to be in the wanted unit; 1 if its name states none. A name states a
/// unit behind its last _ ("E_kPa"), or in brackets at its end ("E (kPa)", "E [kPa]"). A single letter behind _ is
/// none, but a part of the name ("E_s").
/// @throws std::invalid_argument if it states a unit of another dimension, or one with wrong capital letters
double factor_of_column(std::string_view name, std::string_view wanted);

} // namespace matrigrate::units
