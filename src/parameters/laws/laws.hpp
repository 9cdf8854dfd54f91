#pragma once

#include "parameters/laws/law.hpp"

#include <string>

namespace matrigrate {

/// The laws of a set of parameters, except that of the fibres, which has a table (ecm/law/fibre_table.hpp): derived
/// from Parameters, one set for each Workspace, since a formula is evaluated by one thread at a time. Test:
/// tests/unit/parameters/law_test.cpp, tests/physics/laws_test.cpp
struct Laws {
  Laws() = default; ///< the default ones

  /// @throws std::invalid_argument saying what cannot be read; rules() say it with its place
  explicit Laws(const Parameters& p);

  Law curvature_factor;
  Law disassembly_rate;
  Law growth_force;
  Law initiation_rate;
  Law initiation_bias;
  Law polarization_rate;
  Law degradation_tip;
  Law degradation_protrusion;
  Law degradation_body;
};

/// The constants of the user that a law names, as given: "F_c = 0.05 nN, r_c = 0.2 1/s".
std::string constants_of(const Row& law, const Parameters& p);

/// The default ones; any thread may use them.
const Laws& usual_laws();

} // namespace matrigrate
