#include "ecm/law/material.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

/// Displacement [um] of the middle of a layer under a uniform body force, from rest, over time [s].
report::Series creep_of(Simulation& a, const Vec2& b, double seconds) {
  report::Series creep{.x = {0.0}, .y = {0.0}};
  const Vec2 direction = b.normalized();
  a.march_for(seconds, body_force(a.p, b), [&](const State& s) {
    creep.add(s.t, direction.dot(mid_displacement(s.ecm, a.p.ecm)));
    return true;
  });
  return creep;
}

/// What a layer of some height shows, over the closed form with walls at their innermost rows.
struct Reading {
  double tau; // [-]
  double u;   // final displacement [-]
};

/// Value for an infinitely high layer: the walls' place is known to about a spacing, an error of first order in dp/H.
double extrapolated(double low, double high) { return 2.0 * high - low; }

/// One direction of load: checks the time constant and the final displacement, and adds its curves.
void examine(const Parameters& p, const std::string& name, const Vec2& direction, double modulus, Result& result,
             report::Plot& plot) {
  const double tau = lattice_viscosity(p.ecm) / modulus, dp = p.ecm.particle_spacing;
  Parameters q = p;
  q.run.time_step = std::min(p.run.time_step, tau / 40.0);
  const double strain = 1e-3;
  std::vector<Reading> readings;
  for (const int rows : {24, 49}) { // wall distances of 25 and 50 spacings
    const double b = 8.0 * modulus * strain / (rows * dp);
    Simulation a(q, strip(p.ecm, 12 * dp, rows * dp));
    const double walls = wall_distance(a.s.ecm);
    const report::Series creep = creep_of(a, b * direction, 9.0 * tau);
    const std::vector<double>&t = creep.x, &u = creep.y;
    const double u_end = b * walls * walls / (8.0 * modulus);
    readings.push_back({fit_time_constant(t, u, u.back()) / tau, u.back() / u_end});
    report::Series measured{.label = fmt::format("{}, {:.0f} µm high", name, walls), .mark = report::Mark::points};
    for (std::size_t k = 0; k < t.size(); ++k) {
      result.table.add({direction.x() != 0.0 ? 0.0 : 1.0, walls, t[k], u[k], u_end * (1.0 - std::exp(-t[k] / tau))});
      if (k % (t.size() / 24) == 0) measured.add(t[k] / tau, u[k] / u_end);
    }
    plot.series.push_back(std::move(measured));
  }
  const double off = readings[0].tau - readings[1].tau; // half of the first-order error of the lower layer
  const double second = 4.0 * off * off + std::pow(2.0 / 25.0, 2);
  result.checks.push_back(
      {fmt::format("retardation time over mu/modulus, {}", name), extrapolated(readings[0].tau, readings[1].tau), 1.0,
       second + 0.5 * q.run.time_step / tau + std::exp(-9.0) / 0.05,
       "from two heights to an infinite one: second order in dp/H is left; half a step of explicit Euler"});
  result.checks.push_back({fmt::format("final displacement over the closed form, {}", name),
                           extrapolated(readings[0].u, readings[1].u), 1.0, second + std::exp(-9.0),
                           "from two heights to an infinite one: second order in dp/H is left"});
  result.remarks.push_back(
      fmt::format("{}: in a layer of 25 spacings the time constant is {:+.1f} % and the displacement {:+.1f} % off; in "
                  "one of 50, {:+.1f} % and {:+.1f} %. A rigid wall acts about half a spacing behind its first row.",
                  name, 100 * (readings[0].tau - 1), 100 * (readings[0].u - 1), 100 * (readings[1].tau - 1),
                  100 * (readings[1].u - 1)));
}

} // namespace

Result creep(const Parameters& p) {
  Result result;
  const Moduli m = moduli(p.ecm);
  result.table.columns = {"confined_compression", "wall_distance_um", "time_s", "displacement_um", "closed_form_um"};
  report::Plot plot{.title = "Creep of a layer under a constant body force",
                    .x_label = "time in retardation times, viscosity over modulus",
                    .y_label = "displacement / closed form at rest"};
  examine(p, "shear", Vec2(1.0, 0.0), m.G, result, plot);
  examine(p, "confined compression", Vec2(0.0, 1.0), m.longitudinal(), result, plot);
  report::Series closed{.label = "1 - exp(-t/tau)"};
  for (int k = 0; k <= 90; ++k) closed.add(0.1 * k, 1.0 - std::exp(-0.1 * k));
  plot.series.push_back(std::move(closed));
  result.remarks.push_back(
      fmt::format("The closed form uses the viscosity of the pair drag on the ideal lattice, {:.4f} of the nominal mu, "
                  "because Eq. (2) adds 0.01 h^2 to |x_ij|^2. The drag is mu times the Laplacian of v, so confined "
                  "compression retards with mu/(K + 4G/3), not with (4/3 mu)/(K + 4G/3) as in a Newtonian fluid.",
                  lattice_viscosity(p.ecm) / p.ecm.viscosity));
  result.add("creep", "Displacement of the middle of a layer between rigid walls.", plot);
  return result;
}

} // namespace matrigrate::validation
