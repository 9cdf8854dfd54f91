#include "validation/case.hpp"

#include "simulation/step_limits.hpp"
#include "validation/cases.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

bool Check::holds() const {
  return sense == Sense::near ? std::abs(measured - expected) <= tolerance : measured >= expected - tolerance;
}

bool Result::holds() const {
  return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.holds(); });
}

Parameters default_parameters() {
  Parameters p;
  p.solver.tolerance = 1e-6;
  return p;
}

Result run_case(const Case& which, const Parameters& p) {
  require_stable_step(p);
  return which.run(p);
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"patch", "A linear displacement field is reproduced exactly, with and without free edges.", patch},
      {"rigid", "Rigid translation and rotation make no stress and no force; a stress present turns along.", rigid},
      {"stretch", "Young's modulus and Poisson's ratio from a uniaxial test of a free specimen.", stretch},
      {"creep", "Kelvin-Voigt retardation times of a layer under shear and under confined compression.", creep},
      {"relaxation", "Ramp and hold, then release: viscous and elastic share of the stress, recovery time.",
       relaxation},
      {"point-force", "Displacement field of a kernel-distributed force in a clamped disc, as E varies.", point_force},
      {"poiseuille", "Viscosity of the fluidized matrix from plane channel flow, fresh and after shearing.",
       poiseuille},
      {"tearing", "A held adhesion-like load: the solid over reference and over current neighbours.", tearing},
      {"convergence", "Orders of convergence in particle spacing and in time step.", convergence},
      {"step-limit", "The largest stable explicit step, measured, against the analysis of the discrete operators.",
       step_limit},
      {"fibres", "Isotropic fibrillar gels of three concentrations against rheometry and the semi-affine law.", fibres},
      {"fibres-uniaxial", "A gel of parallel fibres, pulled along and across them.", fibres_uniaxial},
      {"protrusion", "Length of a single protrusion over time, as E and direction vary.", protrusion},
      {"maturation", "Maturation of a single protrusion, as E varies.", maturation},
      {"time-step", "One protrusion followed with shorter and shorter steps, and with adaptive ones.", time_step},
      {"disassembly", "Rate of disassembly against force (Eq. 7); lifetimes under constant force.", disassembly},
      {"initiation", "Waiting times and places of protrusions of a polarized cell.", initiation},
  };
  return all;
}

} // namespace matrigrate::validation
