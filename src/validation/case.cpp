#include "validation/case.hpp"

#include "simulation/step_limits.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

// Each is in the file of its name. Geometry and loads are a case's own; material and numerics come from the parameters.
using CaseOf = Result(const Parameters&);
CaseOf patch, rigid, stretch, creep, relaxation, point_force, load, poiseuille, tearing, convergence, step_limit,
    fibres, fibres_uniaxial, protrusion, maturation, time_step, disassembly, initiation, follow;

bool Check::holds() const {
  switch (sense) {
  case Sense::at_least:
    return measured >= expected - tolerance;
  case Sense::at_most:
    return measured <= expected + tolerance;
  case Sense::near:
    break;
  }
  return std::abs(measured - expected) <= tolerance;
}

bool Result::holds() const { return !checks.empty() && std::ranges::all_of(checks, &Check::holds); }

report::Series Result::curve(std::string label, std::string_view x, std::string_view y, report::Mark mark) const {
  return {.label = std::move(label), .x = table.column(x), .y = table.column(y), .mark = mark};
}

void Result::add(std::string name, std::string caption, report::Plot plot) {
  plot.name = std::move(name);
  plot.caption = std::move(caption);
  plots.push_back(std::move(plot));
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
      {"load", "Compliance and creep of a point that is loaded as an adhesion, against the continuum.", load},
      {"poiseuille", "Viscosity of the fluidized matrix from plane channel flow, fresh and after shearing.",
       poiseuille},
      {"tearing", "A held adhesion-like load: the gel comes to rest, and does not tear.", tearing},
      {"convergence", "Orders of convergence in particle spacing and in time step.", convergence},
      {"step-limit", "The largest stable explicit step, measured, against the analysis of the discrete operators.",
       step_limit},
      {"fibres",
       "Isotropic fibrillar gels of three concentrations, stretched with held sides, against the semi-affine law.",
       fibres},
      {"fibres-uniaxial", "A gel of parallel fibres, stretched along and across them with held sides.",
       fibres_uniaxial},
      {"protrusion", "Length of a single protrusion over time, as E and direction vary.", protrusion},
      {"maturation", "Maturation of a single protrusion, as E varies.", maturation},
      {"time-step", "One protrusion followed with shorter and shorter steps, and with adaptive ones.", time_step},
      {"disassembly", "Rate of disassembly against force (Eq. 7); lifetimes under constant force.", disassembly},
      {"follow", "A lone protrusion whose adhesion never lets go: how far the body follows, and what stops it.",
       follow},
      {"initiation", "Waiting times and places of protrusions of a polarized cell.", initiation},
  };
  return all;
}

} // namespace matrigrate::validation
