#include "simulation/events.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "cell/spring.hpp"
#include "contact/degrade.hpp"
#include "cues/diffusion.hpp"
#include "cues/sensing.hpp"
#include "protrusion/deflection.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "protrusion/life_cycle.hpp"
#include "protrusion/polarization.hpp"
#include "simulation/law_places.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace matrigrate {

namespace {

/// Front of the cell; all of it before the first protrusion.
std::vector<std::uint8_t> front_of(const Cell& cell) {
  return cell.polarization ? front(cell.cortex, *cell.polarization) : std::vector<std::uint8_t>(cell.cortex.size(), 1);
}

/// Where the tips of growing protrusions were in the middle of the step.
std::vector<Vec2> tips_of(const Cell& cell, const Parameters& p, double dt) {
  std::vector<Vec2> tips;
  const CortexState& c = cell.cortex;
  for (const Protrusion& protrusion : cell.protrusions)
    if (std::holds_alternative<Growing>(protrusion.phase))
      for (const std::size_t i : pushing_particles(c, protrusion.centre, p.protrusion))
        tips.push_back(c.x[i] - 0.5 * dt * c.v[i]);
  return tips;
}

/// Entry by entry; an empty factor is 1 for all.
std::vector<double> product(std::vector<double> a, std::span<const double> b) {
  if (a.empty()) return {b.begin(), b.end()};
  for (std::size_t i = 0; i < b.size(); ++i) a[i] *= b[i];
  return a;
}

} // namespace

void degrade_around_cells(State& s, const Parameters& p, double dt, Workspace& w) {
  for (std::size_t k = 0; k < s.cells.size(); ++k) {
    const CellShape& shape = w.cells[k];
    std::vector<std::uint8_t> of_front;
    if (p.degradation.rear_share != 1.0) of_front = front_of(s.cells[k]);
    degrade(s.ecm, p, shape.nearby, {shape.membership.on_protrusion, of_front, shape.places},
            tips_of(s.cells[k], p, dt), dt, w.laws.front());
    w.health.engulfed += fluidize_engulfed(s.ecm, p, shape.nearby);
  }
}

void advance_attractant(State& s, const Parameters& p, double dt, Workspace& w) {
  if (w.diffusion) w.diffusion->advance(s.ecm, p.cues.diffusion, attractant_loss(s, p.cues), dt);
}

bool advance_protrusions(Cell& cell, const EcmState& ecm, const Instant& now, const Parameters& p, double dt,
                         const Laws& laws, std::span<const double> given) {
  const Vec2 centre = centre_of_mass(cell.cortex);
  const std::vector<Vec2> n = normals(cell.cortex);
  deflect(cell, ecm, p, dt, n, [&](const Vec2& point) { return contains(cell.cortex, point); });
  update_protrusions(cell, ecm, now, p, dt, laws, places_of_transitions(cell, ecm, p, now.t, laws));
  polarize(cell, centre, dt, laws.polarization_rate,
           place_of_centre(cell, centre, ecm, p, now.t, laws.polarization_rate));
  const std::vector<std::uint8_t> of_front = front_of(cell);
  const std::vector<double> bias = propensity(cell, ecm, p, laws.initiation_bias, now.t);
  const std::vector<double> propensity_with_cues = product(bias, given);
  const std::vector<double> rate = along_cortex(laws.initiation_rate, cell, ecm, p, now.t);
  initiate(cell, now, p, dt,
           {of_front, n, centre, area(cell.cortex) / initial_area(p.cell), rate, propensity_with_cues});
  ratchet_rest_lengths(cell.cortex, p.cell, membership(cell, p).soft);
  return bias.empty();
}

void require_inside(const State& s, const Parameters& p) {
  const double room = p.ecm.radius - 4.0 * p.ecm.smoothing_length; // the rim and what feels it
  for (const Cell& cell : s.cells)
    for (const Vec2& x : cell.cortex.x)
      if (x.norm() > room)
        throw NumericalFailure(
            FailureCause::rim,
            fmt::format("step {} (t = {:.6g} s): the cell has reached the clamped rim of the matrix at "
                        "({:.4g}, {:.4g}) um; take a larger ecm.radius",
                        s.step, s.t, x.x(), x.y()));
}

} // namespace matrigrate
