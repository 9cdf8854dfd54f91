#pragma once

#include "parameters/schema.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace matrigrate {

// From a value as typed to a parameter. Test: tests/unit/parameters/read_test.cpp

/// A value of a TOML file.
struct Given {
  std::variant<std::monostate, bool, std::int64_t, double, std::string> value; ///< monostate: any other type
  std::string_view type;                                                       ///< in words: "an array"
};

/// A number in digits; empty of what is none.
std::string digits_of(const Given& given);

/// Sets the parameter of the row to a value, or leaves it as it is and says why.
/// @return what is wrong and what is allowed; empty if nothing is
std::string assign(const Row& row, const Given& given, Parameters& p);

/// The kind of a value in words: "a table", "a number".
std::string_view type_of(const toml::node& node);

/// The value as assign() takes it.
Given given_by(const toml::node& node);

// Values judged one by one, for Python, with the words of the reader. Rules that join parameters are not tried. Test:
// tests/unit/parameters/parameters_test.cpp

struct Judged {
  std::string fault;   ///< empty if nothing is wrong
  double number = 0.0; ///< in the documented unit; 0 of what is no real number
};

/// @param path  of a parameter; cells.x and cells.y of the keys of [[cells]]; changes.at, and "changes." before the
///              path of a parameter, of [[changes]]
Judged judged(std::string_view path, const Given& value);

/// What is wrong with the name of a parameter, or of a section, that nothing has.
std::string unknown_name(std::string_view path, bool section);

} // namespace matrigrate
