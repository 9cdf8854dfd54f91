#include "validation/single_protrusion.hpp"

#include "cell/geometry.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "simulation/start.hpp"

#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr double radius = 75.0; // of the matrix [um]
constexpr double offset = 20.0; // of the cell from the centre, against the direction of growth [um]

Parameters lasting(Parameters p, double angle) {
  p.ecm.radius = radius;
  p.cell.start_x = -offset * std::cos(angle);
  p.cell.start_y = -offset * std::sin(angle);
  p.protrusion.initiation_rate = 0.0;
  p.protrusion.number = 0;
  p.adhesion.r_off_min = 0.0;
  p.adhesion.r_off_0 = 0.0;
  return p;
}

} // namespace

SingleProtrusion::SingleProtrusion(const Parameters& p, double angle)
    : m_simulation(lasting(p, angle), initial_state(lasting(p, angle))) {
  Cell& cell = m_simulation.s.cells.front();
  const CortexState& c = cell.cortex;
  const double turns = angle / (2.0 * std::numbers::pi);
  const auto i = static_cast<std::size_t>(std::lround(turns * static_cast<double>(c.size()))) % c.size();
  begin_protrusion(cell, i, centroid(c), m_simulation.s.t, m_simulation.p.protrusion);
}

void SingleProtrusion::march_for(double seconds, const std::function<bool(const State&)>& each_step) {
  m_simulation.march_for(seconds, {}, each_step);
}

double SingleProtrusion::length() const {
  return protrusion_length(cell().cortex, protrusion().centre, m_simulation.p.protrusion);
}

} // namespace matrigrate::validation
