#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

/// Viscosity from the curvature of the velocity profile, v = v_0 - b/(2 mu) y^2, which does not depend on the walls'
/// place.
double profile_viscosity(const EcmState& ecm, double b, double half_width) {
  report::Series profile; // of v over y^2
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (!ecm.clamped[i] && std::abs(ecm.x[i].y()) <= half_width) profile.add(ecm.x[i].y() * ecm.x[i].y(), ecm.v[i].x());
  return -b / (2.0 * fit_slope(profile.x, profile.y));
}

} // namespace

Result poiseuille(const Parameters& p) {
  Result result;
  const double dp = p.ecm.particle_spacing;
  const double mu = lattice_viscosity(p.ecm);
  Simulation a(p, strip(p.ecm, 16 * dp, 24 * dp));
  std::fill(a.s.ecm.f.begin(), a.s.ecm.f.end(), 0.0);
  const double H = wall_distance(a.s.ecm);
  const double wall_rate = 0.02; // shear rate at the wall [1/s]
  const double b = 2.0 * p.ecm.viscosity * wall_rate / H;
  const double inner = 0.5 * H - 2.0 * p.ecm.smoothing_length; // where no kernel reaches a wall

  result.table.columns = {"wall_shear_strain", "viscosity_Pa_s"};
  report::Series profile{.label = "first step", .mark = report::Mark::points};
  a.march_for(150.0, body_force(p, Vec2(b, 0.0)), [&](const State& s) {
    if (s.step == 1)
      for (std::size_t i = 0; i < s.ecm.size(); ++i) profile.add(s.ecm.X[i].y(), s.ecm.v[i].x());
    result.table.add({wall_rate * s.t, 1e3 * profile_viscosity(s.ecm, b, inner)});
    return true;
  });
  const double fresh = result.table.rows.front()[1];
  std::vector<double> late;
  for (const auto& row : result.table.rows)
    if (row[0] > 2.0) late.push_back(row[1]);
  std::nth_element(late.begin(), late.begin() + static_cast<std::ptrdiff_t>(late.size() / 2), late.end());
  const double sheared = late[late.size() / 2];

  result.checks.push_back({"viscosity of fresh fluid against the lattice sum (Pa s)", fresh, 1e3 * mu,
                           1e3 * mu * dp * dp / (inner * inner),
                           "second order in the spacing over the half-width that is read"});
  double lowest = mu, highest = mu; // over all ways in which the rows can stand against each other
  for (int k = 0; k <= 100; ++k) {
    const double sheared_mu = sheared_lattice_viscosity(p.ecm, 0.01 * k);
    lowest = std::min(lowest, sheared_mu);
    highest = std::max(highest, sheared_mu);
  }
  result.checks.push_back({"median viscosity at wall strains 2 to 3 (Pa s)", sheared, 500.0 * (lowest + highest),
                           500.0 * (highest - lowest) + 1e3 * mu * dp * dp / (inner * inner),
                           "range of the lattice sum over all shears of the rows; second order in the spacing"});
  result.remarks.push_back(fmt::format("On the fresh lattice the pair drag of Eq. (2) is {:.1f} % below the nominal "
                                       "viscosity: 0.01 h^2 in its denominator, and a kernel sampled at {} neighbours.",
                                       100.0 * (1.0 - mu / p.ecm.viscosity),
                                       lattice_patch(p.ecm, 2.0 * p.ecm.smoothing_length).size() - 1));
  report::Series exact{.label = "parabola", .mark = report::Mark::line};
  for (int k = 0; k <= 60; ++k) {
    const double y = H * (k / 60.0 - 0.5);
    exact.add(y, b / (2.0 * mu) * (0.25 * H * H - y * y));
  }
  result.add("poiseuille", "Velocity over the channel; the wall rows stand still.",
             {.title = "Poiseuille: fluidized matrix between walls",
              .x_label = "y (µm)",
              .y_label = "velocity (µm/s)",
              .series = {exact, profile}});
  result.add("strain", "Rows slide past each other while the fluid flows.",
             {.title = "Poiseuille: viscosity while the fluid is sheared",
              .x_label = "shear strain at the wall",
              .y_label = "viscosity (Pa s)",
              .series = {result.curve("from the curvature of the profile", "wall_shear_strain", "viscosity_Pa_s")}});
  return result;
}

} // namespace matrigrate::validation
