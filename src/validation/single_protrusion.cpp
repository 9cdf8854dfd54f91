#include "validation/single_protrusion.hpp"

#include "cell/geometry.hpp"
#include "ecm/degradation.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "simulation/start.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr double radius = 75.0; // of the matrix [um]
constexpr double offset = 20.0; // of a cell with one protrusion from the centre, against the direction of growth [um]

Parameters lasting(Parameters p, const Vec2& start) {
  p.ecm.radius = radius;
  p.cell.start_x = start.x();
  p.cell.start_y = start.y();
  p.protrusion.initiation_rate = 0.0;
  p.protrusion.number = 0;
  p.adhesion.r_off_min = 0.0;
  p.adhesion.r_off_0 = 0.0;
  return p;
}

State initial(const Parameters& p, const std::function<bool(const Vec2&)>& fluid) {
  State s = initial_state(p);
  for (std::size_t i = 0; i < s.ecm.size() && fluid; ++i)
    if (!s.ecm.clamped[i] && fluid(s.ecm.X[i])) fluidize(s.ecm, i);
  return s;
}

} // namespace

PlacedProtrusions::PlacedProtrusions(const Parameters& p, const Vec2& start,
                                     const std::function<bool(const Vec2&)>& fluid)
    : m_simulation(lasting(p, start), initial(lasting(p, start), fluid)) {}

void PlacedProtrusions::begin(double angle, double tilt) {
  Cell& cell = m_simulation.s.cells.front();
  const CortexState& c = cell.cortex;
  const double turns = angle / (2.0 * std::numbers::pi);
  const auto i = static_cast<std::size_t>(std::lround(turns * static_cast<double>(c.size()))) % c.size();
  const Vec2 out = c.x[i] - centroid(c);
  begin_protrusion(cell, i, c.x[i] - Eigen::Rotation2Dd(tilt) * out, m_simulation.s.t, m_simulation.p.protrusion);
}

void PlacedProtrusions::march_for(double seconds, const std::function<bool(const State&)>& each_step,
                                  const Loads& loads) {
  m_simulation.march_for(seconds, loads, each_step);
}

double PlacedProtrusions::length(std::size_t k) const {
  return protrusion_length(cell().cortex, cell().protrusions[k].centre, parameters().protrusion);
}

double PlacedProtrusions::base_width(std::size_t k) const {
  return matrigrate::base_width(cell().cortex, cell().protrusions[k].centre, parameters().protrusion);
}

double PlacedProtrusions::slack(std::size_t k) const {
  const CortexState& c = cell().cortex;
  const std::size_t centre = cell().protrusions[k].centre;
  const int half = parameters().protrusion.half_width;
  double contour = 0.0;
  for (int i = -half; i < half; ++i) contour += (c.x[c.along(centre, i + 1)] - c.x[c.along(centre, i)]).norm();
  const Vec2& tip = c.x[centre];
  return contour / ((c.x[c.along(centre, -half)] - tip).norm() + (c.x[c.along(centre, half)] - tip).norm());
}

SingleProtrusion::SingleProtrusion(const Parameters& p, double angle)
    : PlacedProtrusions(p, -offset * Vec2(std::cos(angle), std::sin(angle))) {
  begin(angle);
}

} // namespace matrigrate::validation
