#include "simulation/motion.hpp"

#include "base/parallel.hpp"
#include "ecm/loop/stress.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"

namespace matrigrate {

namespace {

void advance_positions(State& s, const Parameters& p, double dt, const Workspace& w) {
  parallel_for(s.ecm.size(), [x = s.ecm.x.data(), v = s.ecm.v.data(), dt](std::size_t i) { x[i] += dt * v[i]; });
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    CortexState& c = s.cells[k].cortex;
    for (std::size_t i = 0; i < c.size(); ++i) c.x[i] += dt * c.v[i];
    CortexState& nucleus = s.cells[k].nucleus;
    for (std::size_t i = 0; i < nucleus.size(); ++i) nucleus.x[i] += dt * nucleus.v[i];
    spread_evenly(s.cells[k], p.protrusion, dt);
    move_anchors(s.cells[k], s.ecm, w.cells[k].anchor_weights, dt);
  }
}

} // namespace

void move(State& s, const Parameters& p, double dt, Workspace& w) {
  advance_positions(s, p, dt, w);
  const DensityBounds bounds = advance_stress(s.ecm, p.ecm, w.reference, w.solid, dt);
  w.health.density_bounds = bounds.below + bounds.above;
}

} // namespace matrigrate
