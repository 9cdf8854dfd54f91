#pragma once

#include "parameters/schema.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// A changed law drawn beside the default one. Test: tests/unit/parameters/law_test.cpp
namespace matrigrate {

/// The values of a law over one of its arguments, between drawn_low and drawn_high, the others at their usual values.
struct LawCurve {
  LawVariable over;
  std::string at; ///< those of the others that matter: "f_mat = 0.5, t = 0 s"; empty where none does
  std::vector<double> x;
  std::vector<double> usual;   ///< of the default law, with the parameters as they are
  std::vector<double> changed; ///< not finite where it is so
};

/// Over each argument that the law depends on; of one that depends on none, over the first of the default law.
/// @param points  >= 2
std::vector<LawCurve> law_curves(const Parameters& p, const Row& law, std::size_t points);

} // namespace matrigrate
