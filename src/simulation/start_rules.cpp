#include "simulation/start_rules.hpp"

#include "ecm/bonds.hpp"
#include "simulation/step_limits.hpp"

#include <vector>

namespace matrigrate {

std::span<const Rule> start_rules() {
  static const std::vector<Rule> all{
      {"the step is stable",
       {"run.time_step", "run.integrator", "ecm.youngs_modulus", "ecm.poissons_ratio", "ecm.viscosity",
        "fibres.stiffness", "fibres.arrangement", "fibres.direction_deg", "fibres.half_angle_deg",
        "fibres.plane_to_space", "ecm.particle_spacing", "ecm.smoothing_length", "ecm.lattice", "ecm.hourglass_weight",
        "ecm.thickness"},
       [](const Parameters& p) { return fault_of_step(p, step_limits(p)); }},
      {"fibres lie on bonds",
       {"fibres.direction_deg", "fibres.half_angle_deg", "fibres.arrangement", "ecm.lattice", "ecm.smoothing_length",
        "ecm.particle_spacing"},
       fault_of_fibres},
  };
  return all;
}

} // namespace matrigrate
