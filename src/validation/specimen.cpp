#include "validation/specimen.hpp"

#include "cell/geometry.hpp"
#include "ecm/law/material.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/initiation.hpp"
#include "simulation/start.hpp"
#include "validation/closed_forms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace matrigrate::validation {

namespace {

/// Of a single protrusion.
Parameters lasting(Parameters p, double angle) {
  constexpr double offset = 20.0; // of the cell from the centre, against the direction of growth [um]
  p.ecm.radius = 75.0;
  p.cell.start_x = -offset * std::cos(angle);
  p.cell.start_y = -offset * std::sin(angle);
  p.protrusion.initiation_rate = 0.0;
  p.protrusion.number = 0;
  p.adhesion.r_off_min = 0.0;
  p.adhesion.r_off_0 = 0.0;
  return p;
}

} // namespace

Parameters with_disc(Parameters p, double radius) {
  p.ecm.radius = radius;
  p.ecm.cell_hole = false;
  return p;
}

double clamp_radius(const EcmParameters& p) { return p.radius - 2.0 * p.smoothing_length + 0.5 * p.particle_spacing; }

double continuum_compliance(const EcmParameters& p, double width) {
  return clamped_disc_compliance(Kernel(width), clamp_radius(p), moduli(p).G, p.poissons_ratio) / p.thickness;
}

Loads body_force(const Parameters& p, const Vec2& b) {
  return [t_z = p.ecm.thickness, b](const State& s, std::span<Vec2> force) {
    for (std::size_t i = 0; i < s.ecm.size(); ++i)
      if (!s.ecm.clamped[i]) force[i] += s.ecm.V0 * t_z * b;
  };
}

void move_clamped(EcmState& ecm, const std::function<Vec2(const Vec2&)>& v) {
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) ecm.v[i] = v(ecm.X[i]);
}

void drive_clamped(Simulation& a, const std::function<Vec2(const Vec2&)>& u, double seconds, const Loads& loads) {
  const double whole = std::round(seconds / a.p.run.time_step) * a.p.run.time_step;
  move_clamped(a.s.ecm, [&](const Vec2& X) -> Vec2 { return u(X) / whole; });
  a.march_for(whole, loads);
  move_clamped(a.s.ecm, [](const Vec2&) { return Vec2::Zero(); });
}

Vec2 mid_displacement(const EcmState& ecm, const EcmParameters& p) {
  Vec2 sum = Vec2::Zero();
  int count = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.clamped[i] || std::abs(ecm.X[i].y()) > 0.51 * p.particle_spacing) continue;
    sum += ecm.displacement(i);
    ++count;
  }
  return sum / std::max(count, 1);
}

double wall_distance(const EcmState& ecm) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) nearest = std::min(nearest, std::abs(ecm.X[i].y()));
  return 2.0 * nearest;
}

SingleProtrusion::SingleProtrusion(const Parameters& material, double angle) : Simulation(lasting(material, angle)) {
  const CortexState& c = s.cells.front().cortex;
  const double turns = angle / (2.0 * std::numbers::pi);
  const auto i = static_cast<std::size_t>(std::lround(turns * static_cast<double>(c.size()))) % c.size();
  begin_protrusion(s.cells.front(), i, centroid(c), s.t, p.protrusion);
}

double SingleProtrusion::length() const { return protrusion_length(cell().cortex, protrusion().centre, p.protrusion); }

} // namespace matrigrate::validation
