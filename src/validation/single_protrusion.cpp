#include "validation/single_protrusion.hpp"

#include "protrusion/growth.hpp"
#include "simulation/start.hpp"

#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr double radius = 75.0; // of the matrix [um]
constexpr double offset = 20.0; // of the cell from the centre, against the direction of growth [um]

Parameters alone(Parameters p, double angle) {
  p.ecm.radius = radius;
  p.cell.start_x = -offset * std::cos(angle);
  p.cell.start_y = -offset * std::sin(angle);
  p.protrusion.initiation_rate = 0.0;
  p.adhesion.r_off_min = 0.0;
  p.adhesion.r_off_0 = 0.0;
  return p;
}

} // namespace

SingleProtrusion::SingleProtrusion(Parameters p, double angle)
    : m_specimen(initial_state(alone(p, angle)), alone(p, angle)) {
  State& s = m_specimen.s;
  const double turns = angle / (2.0 * std::numbers::pi);
  const auto centre = static_cast<std::uint32_t>(std::lround(turns * static_cast<double>(s.cortex.size())));
  const Vec2 middle(m_specimen.p.cell.start_x, m_specimen.p.cell.start_y);
  Protrusion first;
  first.centre = centre;
  first.phase = Growing{(s.cortex.x[centre] - middle).normalized()};
  first.record.id = ++s.initiated;
  first.record.centre = centre;
  first.record.t_initiation = 0.0;
  s.protrusions.push_back(first);
}

void SingleProtrusion::march_for(double seconds, const std::function<bool(const State&)>& each_step) {
  m_specimen.march_for(seconds, {}, each_step);
}

double SingleProtrusion::length() const {
  return protrusion_length(state().cortex, protrusion().centre, m_specimen.p.protrusion);
}

} // namespace matrigrate::validation
