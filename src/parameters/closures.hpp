#pragma once

#include "parameters/parameters.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Which set of closures the parameters of a run belong to. Versions had other sets as their defaults; a file that
/// names some values of one and leaves out others mixes them. Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

/// A parameter that the sets differ in.
struct ClosureValue {
  std::string_view key;
  std::string value;                  ///< as it stands in a scenario file
  std::vector<std::string_view> sets; ///< that have this value; none if it is of no set
};

struct Closures {
  std::string_view set; ///< "first", "second" or "third", the default; "mixed" if no set has all values that
                        ///< any set has
  std::vector<ClosureValue> values; ///< all that the sets differ in
};

Closures closures_of(const Parameters& p);

/// "third set"; "third set, but for contact.fluid_share = 0.3"; "mixed: ... of the second set, ... of the third"
std::string closures_text(const Closures& closures);

/// What to do about closures that are not those of today's default, a sentence; empty for the third set, with or
/// without values of no set.
std::string closures_note(const Closures& closures);

} // namespace matrigrate
