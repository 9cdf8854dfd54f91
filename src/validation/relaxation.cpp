#include "ecm/law/material.hpp"
#include "observe/reaction.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double rate = 1e-4; // shear rate of the ramp [1/s]

struct RampAndHold {
  double before = 0.0; // wall stress in the last step of the ramp [kPa]
  double after = 0.0;  // wall stress at the end of the hold [kPa]
  double strain = 0.0;
};

/// Shears a layer at a constant rate, then holds it; wall stress over time goes into the table.
RampAndHold ramp_and_hold(const Parameters& p, double ramp, double hold, store::Table& table) {
  const double dp = p.ecm.particle_spacing;
  Simulation a(p, strip(p.ecm, 12 * dp, 49 * dp));
  const double H = wall_distance(a.s.ecm);
  RampAndHold r;
  const auto record = [&](const State& s) {
    const Vec2 force = clamp_force(s, a.p, a.w, [](const Vec2& X) { return X.y() > 0.0; });
    r.after = force.x() / (s.ecm.period_x * a.p.ecm.thickness);
    table.add({s.t, rate * std::min(s.t, ramp), 1e3 * r.after});
    return true;
  };
  move_clamped(a.s.ecm, [&](const Vec2& X) { return Vec2(X.y() > 0.0 ? rate * H : 0.0, 0.0); });
  a.march_for(ramp, {}, record);
  r.before = r.after;
  r.strain = rate * a.s.t;
  move_clamped(a.s.ecm, [](const Vec2&) { return Vec2::Zero(); });
  a.march_for(hold, {}, record);
  return r;
}

/// Loads a layer for a while, takes the load off, and gives the time constant of the way back.
double recovery_time(const Parameters& p, double tau) {
  const double dp = p.ecm.particle_spacing;
  Simulation a(p, strip(p.ecm, 12 * dp, 49 * dp));
  a.march_for(2.0 * tau, body_force(p, Vec2(1e-5, 0.0)));
  report::Series way{.x = {0.0}, .y = {mid_displacement(a.s.ecm, p.ecm).x()}};
  const double start = a.s.t;
  a.march_for(9.0 * tau, {}, [&](const State& s) {
    way.add(s.t - start, mid_displacement(s.ecm, p.ecm).x());
    return true;
  });
  return fit_time_constant(way.x, way.y, 0.0);
}

} // namespace

Result relaxation(const Parameters& p) {
  Result result;
  const Moduli m = moduli(p.ecm);
  const double mu = lattice_viscosity(p.ecm);
  const double tau = mu / m.G;
  const double dt = p.run.time_step;
  result.table.columns = {"time_s", "shear_strain", "wall_stress_Pa"};
  const RampAndHold r = ramp_and_hold(p, 3.0 * tau, tau, result.table);
  const double wall = 2.0 / 50.0; // over the height of 50 spacings
  const std::string walls = "walls known to a spacing each";
  result.checks.push_back(
      {"shear modulus from the hold (Pa)", 1e3 * r.after / r.strain, 1e3 * m.G, 1e3 * m.G * wall, walls});
  result.checks.push_back({"viscosity from the drop at the end of the ramp (Pa s)", 1e3 * (r.before - r.after) / rate,
                           1e3 * mu, 1e3 * (mu * wall + m.G * dt),
                           walls + "; one step of ramp between the two readings, G dt"});
  result.checks.push_back({"relaxation time mu/G from the two (s)", (r.before - r.after) / rate / (r.after / r.strain),
                           tau, tau * wall + dt, walls + "; one step"});
  result.checks.push_back({"recovery time after unloading (s)", recovery_time(p, tau), tau, tau * 2.0 * wall + 0.5 * dt,
                           "walls known to a spacing: (H +- dp)^2; half a step of explicit Euler"});

  report::Series expected{.label = "Kelvin-Voigt", .mark = report::Mark::dashed};
  for (const auto& row : result.table.rows)
    expected.add(row[0], 1e3 * (m.G * row[1] + (row[0] <= 3.0 * tau ? mu * rate : 0.0)));
  result.add("relaxation", "A Kelvin-Voigt layer drops by mu times the rate when the ramp ends.",
             {.title = "Relaxation: shear ramp, then hold",
              .x_label = "time (s)",
              .y_label = "wall shear stress (Pa)",
              .series = {result.curve("measured", "time_s", "wall_stress_Pa"), expected}});
  return result;
}

} // namespace matrigrate::validation
