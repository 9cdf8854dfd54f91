#pragma once

#include "parameters/schema.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

/// From a value as typed to a parameter. Test: tests/unit/parameters/read_test.cpp
namespace matrigrate {

/// A value of a TOML file.
struct Given {
  std::variant<std::monostate, bool, std::int64_t, double, std::string> value; ///< monostate: any other type
  std::string_view type;                                                       ///< in words: "an array"
};

/// Sets the parameter of the row to a value, or leaves it as it is and says why.
/// @return what is wrong and what is allowed; empty if nothing is
std::string assign(const Row& row, const Given& given, Parameters& p);

} // namespace matrigrate
