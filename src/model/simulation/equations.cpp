#include "simulation/equations.hpp"

#include "base/parallel.hpp"
#include "cell/actomyosin.hpp"
#include "cell/area.hpp"
#include "cell/bending.hpp"
#include "cell/geometry.hpp"
#include "cell/nucleus.hpp"
#include "cell/repulsion.hpp"
#include "cell/spring.hpp"
#include "contact/cells.hpp"
#include "contact/elastic.hpp"
#include "contact/nucleus.hpp"
#include "contact/viscous.hpp"
#include "ecm/loop/fibres.hpp"
#include "ecm/loop/fluid.hpp"
#include "ecm/loop/stress.hpp"
#include "ecm/loop/viscosity.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/maturation.hpp"
#include "simulation/law_places.hpp"
#include "state/dof.hpp"

#include <algorithm>
#include <numeric>

namespace matrigrate {

namespace {

/// 1/(1 + theta): the system is divided by 1 + theta, so that the drag of the matrix does not depend on the step.
double of_step(const Workspace& w) { return 1.0 / (1.0 + w.theta); }

/// The cortex a quarter of the step on, if it goes on as in the last one; by no more than half of what a step may move
/// it. Lengths of protrusions depend least on the step so (MODEL.md, I12).
CortexState after_a_quarter_step(CortexState c, const Parameters& p, double dt) {
  const double max_move = 0.5 * usual_move * p.ecm.particle_spacing;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec2 move = 0.25 * dt * c.v[i];
    c.x[i] += std::min(1.0, max_move / std::max(max_move, move.norm())) * move;
  }
  return c;
}

Vec2 sum(std::span<const Vec2> forces) { return std::accumulate(forces.begin(), forces.end(), Vec2(0.0, 0.0)); }

/// Right side of Eq. (1) for a cell, in the paper's order. What it does to the matrix waits in w.on_matrix.
void assemble_cell_forces(const State& s, std::size_t k, const Parameters& p, double dt, Workspace& w) {
  const Cell& cell = s.cells[k];
  const CellShape& shape = w.cells[k];
  const std::uint32_t first = first_node(s, k);
  const CortexState& c = cell.cortex;
  const Membership& m = shape.membership;
  const std::span<const Vec2> forces = of_cell(s, k, std::span<const Vec2>(w.force));
  add_springs(c, p.cell, m.k_s, dt, first, w.force, w.drag);
  add_bending(c, p.cell, dt, first, w.force, w.drag);
  add_area(c, p.cell, dt, first, w.force, w.drag);
  add_repulsion(c, p.cell, dt, first, w.force, w.drag);
  add_elastic_contact(s.ecm, c, p, shape.nearby, dt, first, w.force, w.on_matrix, w.drag);
  add_actomyosin(c, m.f_mat, shape.places, dt, first, w.force, w.drag, w.laws.front());
  const Vec2 inner = sum(forces);
  add_growth(cell, p.protrusion, area(c) / initial_area(p.cell), shape.normals, first, w.force, w.drag, s.t,
             w.laws.front().growth_force, shape.places);
  add_base_ties(cell, p.protrusion, p.cell.spring_stiffness, dt, first, w.force, w.drag);
  add_maturation(cell, p, w.laws.front(), shape.places, dt, first, w.force, w.drag);
  w.outer_force += sum(forces) - inner;
  add_adhesions(cell, s.ecm, p.adhesion, w.laws.front(), shape.places, shape.anchor_weights, dt, first, w.force,
                w.on_matrix, w.drag);
}

/// The nucleus of a cell, and its contact with the cortex.
void assemble_nucleus_forces(const State& s, std::size_t k, const Parameters& p, double dt, Workspace& w) {
  const Cell& cell = s.cells[k];
  if (cell.nucleus.size() == 0) return;
  const std::uint32_t cortex = first_node(s, k);
  const std::uint32_t nucleus = first_nucleus_node(s, k);
  add_nucleus(cell.nucleus, p, dt, nucleus, w.force, w.drag);
  add_nucleus_contact(cell, nucleus_touches(cell, p.nucleus), p, dt, cortex, nucleus, w.force, w.drag);
  add_centring(cell, p.nucleus, dt, cortex, nucleus, w.force, w.drag);
}

/// Computes shape, protrusions and surroundings of each cell at x(t), what resists it there, the links of A, and all
/// forces on its nodes.
void assemble_cells(const State& s, const Parameters& p, double dt, Workspace& w) {
  const double reach = 2.0 * p.ecm.smoothing_length;
  w.drag.links.clear();
  w.cells.resize(s.cells.size());
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    const Cell& cell = s.cells[k];
    CellShape& shape = w.cells[k];
    shape.membership = membership(cell, p);
    shape.normals = normals(cell.cortex);
    shape.nearby = nearby_solid(s.ecm, cell.cortex, SegmentGrid(cell.cortex, reach), reach);
    shape.anchor_weights = anchor_weights(cell, s.ecm, p);
    shape.places = places_of_forces(cell, s.ecm, p, s.t, w.laws.front());
    const CortexState c = after_a_quarter_step(cell.cortex, p, dt);
    add_viscous_contact(s.ecm, c, shape.membership.soft, p, SegmentGrid(c, reach), first_node(s, k), w.drag);
  }
  w.touches = cell_touches(s.cells, cell_reach(p.contact.cells));
  w.drag.directed.clear();
  w.on_matrix.clear();
  w.outer_force = Vec2::Zero();
  std::ranges::fill(std::span(w.force).subspan(s.ecm.size()), Vec2::Zero());
  for (std::size_t k = 0; k < s.cells.size(); ++k) assemble_cell_forces(s, k, p, dt, w);
  for (std::size_t k = 0; k < s.cells.size(); ++k) assemble_nucleus_forces(s, k, p, dt, w);
  add_cell_contact(s, w.touches, p, dt, w.force, w.drag);
}

/// What needs the neighbours at x(t): the left side of Eq. (2), with the drag of cells in the liquid, and the pressure
/// of the fluid.
void assemble_drag(const State& s, const Parameters& p, double dt, Workspace& w) {
  if (!w.neighbours.update(s.ecm.x, s.ecm.period_x).empty()) ++w.health.list_builds;
  w.drag_cache.assemble(s.ecm, p.ecm, w.neighbours, s.solver_memory.x_drag, drag_lag(p, dt), w.theta, w.drag);
  w.drag.diagonal.resize(node_count(s), of_step(w) * p.cell.liquid_drag * p.ecm.thickness);
  w.drag.F.resize(node_count(s), Vec2::Zero());
  find_fluid_pressures(s.ecm, p.ecm, w.neighbours.pairs(), w.fluid_pressure);
}

/// Right side of Eq. (2) without cells and fibres, but for what the fluid's pressure does.
void assemble_stress(const State& s, const Parameters& p, Workspace& w) {
  w.reference.update(s.ecm);
  std::ranges::fill(std::span(w.force).first(s.ecm.size()), Vec2::Zero());
  add_elastic_forces(s.ecm, p.ecm, w.reference, w.solid, w.force);
}

} // namespace

void assemble(const State& s, const Parameters& p, double dt, Workspace& w) {
  w.theta = relaxation_theta(p, dt, w.limits);
  w.force.resize(node_count(s));
  side_by_side(
      {[&] { assemble_drag(s, p, dt, w); }, [&] { assemble_cells(s, p, dt, w); }, [&] { assemble_stress(s, p, w); }});
  for (std::size_t k = 0; k < s.cells.size(); ++k) pin_bases(s.cells[k], p, first_node(s, k), w.drag);
  add_fibre_forces(s.ecm, p.ecm, p.fibres, w.fibres, of_step(w) * dt, w.force, w.drag);
  for (double& c : w.drag.links.c) c *= of_step(w);
  for (double& c : w.drag.directed.c) c *= of_step(w);
}

void complete_forces(const State& s, const Parameters& p, Workspace& w, const Loads& loads) {
  add_fluid_forces(s.ecm, p.ecm, w.neighbours.pairs(), w.fluid_pressure, w.force);
  w.on_matrix.add_to(w.force);
  if (loads) {
    const Vec2 inner = sum(w.force);
    loads(s, w.force);
    w.outer_force += sum(w.force) - inner;
  }
  const auto add = [share = of_step(w), F = w.drag.F.data(), force = w.force.data()](std::size_t begin,
                                                                                     std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) F[i] += share * force[i];
  };
  parallel_ranges(s.ecm.size(), light_grain, [&](std::size_t begin, std::size_t end) {
    each_unflagged_stretch(std::span(s.ecm.clamped).subspan(begin, end - begin),
                           [&](std::size_t from, std::size_t to) { add(begin + from, begin + to); });
  });
  add(s.ecm.size(), w.force.size());
}

} // namespace matrigrate
