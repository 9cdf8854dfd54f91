#pragma once

#include "parameters/assign.hpp"

#include <string>
#include <string_view>

/// Values judged one by one, for Python, with the words of the reader. Rules that join parameters are not tried.
/// Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

struct Judged {
  std::string fault;   ///< empty if nothing is wrong
  double number = 0.0; ///< in the documented unit; 0 of what is no real number
};

/// @param path  of a parameter; cells.x and cells.y of the keys of [[cells]]; changes.at, and "changes." before the
/// path
///              of a parameter, of [[changes]]
Judged judged(std::string_view path, const Given& value);

/// What is wrong with the name of a parameter, or of a section, that nothing has.
std::string unknown_name(std::string_view path, bool section);

} // namespace matrigrate
