#include "simulation/equations.hpp"

#include "ecm/fluid.hpp"
#include "ecm/stress.hpp"
#include "ecm/updated_lagrangian.hpp"
#include "ecm/viscosity.hpp"

namespace matrigrate {

void assemble_drag(const State& s, const Parameters& p, Workspace& w) {
  assemble_viscosity(s.ecm, p.ecm, w.neighbours.pairs(), w.drag);
}

void assemble_forces(const State& s, const Parameters& p, Workspace& w, const Loads& loads) {
  const Adjacency& pairs = w.neighbours.pairs();
  w.force.assign(s.ecm.size(), Vec2::Zero());
  switch (p.ecm.formulation) {
  case Formulation::total_lagrangian:
    add_elastic_forces(s.ecm, p.ecm, w.reference, w.F, w.PB, w.force);
    break;
  case Formulation::updated_lagrangian:
    add_current_elastic_forces(s.ecm, p.ecm, pairs, w.force);
    break;
  }
  add_fluid_forces(s.ecm, p.ecm, pairs, w.fluid_pressure, w.force);
  if (loads) loads(s, w.force);
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (!s.ecm.clamped[i]) w.drag.F[i] += w.force[i];
}

} // namespace matrigrate
