#include "simulation/events.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "cell/rest_length.hpp"
#include "contact/degrade.hpp"
#include "protrusion/deflection.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "protrusion/life_cycle.hpp"
#include "protrusion/polarization.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace matrigrate {

namespace {

/// Front of the cell; all of it before the first protrusion.
std::vector<std::uint8_t> front_of(const State& s) {
  return s.polarization ? front(s.cortex, *s.polarization) : std::vector<std::uint8_t>(s.cortex.size(), 1);
}

} // namespace

void degrade_around_cell(State& s, const Parameters& p, double dt, Workspace& w) {
  std::vector<Vec2> tips;
  for (const Protrusion& protrusion : s.protrusions)
    if (std::holds_alternative<Growing>(protrusion.phase))
      for (const std::size_t i : pushing_particles(s.cortex, protrusion.centre, p.protrusion))
        tips.push_back(s.cortex.x[i] - 0.5 * dt * s.cortex.v[i]);
  degrade(s.ecm, p, w.cell.nearby, w.cell.membership.on_protrusion, tips, dt);
  w.health.engulfed += fluidize_engulfed(s.ecm, p, w.cell.nearby);
}

void advance_protrusions(State& s, const Parameters& p, double dt) {
  const Vec2 centre = centroid(s.cortex);
  const std::vector<Vec2> n = normals(s.cortex);
  deflect(s, p, dt, n, [&](const Vec2& point) { return contains(s.cortex, point); });
  update_protrusions(s, p, dt);
  polarize(s, p.polarization, centre, dt);
  const std::vector<std::uint8_t> of_front = front_of(s);
  initiate(s, p, dt, {of_front, n, centre, area(s.cortex) / initial_area(p.cell)});
  ratchet_rest_lengths(s.cortex, p.cell, membership(s, p).soft);
}

void require_inside(const State& s, const Parameters& p) {
  const double room = p.ecm.radius - 4.0 * p.ecm.smoothing_length; // the rim and what feels it
  for (const Vec2& x : s.cortex.x)
    if (x.norm() > room)
      throw NumericalFailure(
          fmt::format("step {} (t = {:.6g} s): the cell has reached the clamped rim of the matrix at "
                      "({:.4g}, {:.4g}) um; take a larger ecm.radius",
                      s.step, s.t, x.x(), x.y()));
}

} // namespace matrigrate
