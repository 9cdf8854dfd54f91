#pragma once

#include "parameters/parameters.hpp"

#include <string>

/// Which set of closures the parameters of a run belong to. Versions had other sets as their defaults; a file that
/// names some values of one and leaves out others mixes them. Test: tests/unit/parameters/parameters_test.cpp
namespace matrigrate {

struct Closures {
  std::string text; ///< "third set"; "third set, but for contact.fluid_share = 0.3"; "mixed: of the third set ...; of
                    ///< the second ..." if no set has all values that any set has
  std::string note; ///< what to do about closures that are not those of today's default, a sentence; empty for the
                    ///< third set, with or without values of no set
};

Closures closures_of(const Parameters& p);

} // namespace matrigrate
