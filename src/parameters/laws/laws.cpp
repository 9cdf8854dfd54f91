#include "parameters/laws/laws.hpp"

namespace matrigrate {

Laws::Laws(const Parameters& p)
    : curvature_factor("laws.curvature_factor", p), disassembly_rate("laws.disassembly_rate", p),
      growth_force("laws.growth_force", p), initiation_rate("laws.initiation_rate", p),
      initiation_bias("laws.initiation_bias", p), polarization_rate("laws.polarization_rate", p),
      degradation_tip("laws.degradation_tip", p), degradation_protrusion("laws.degradation_protrusion", p),
      degradation_body("laws.degradation_body", p) {}

const Laws& usual_laws() {
  static const Laws laws;
  return laws;
}

} // namespace matrigrate
