#include "ecm/law/material.hpp"
#include "ecm/loop/deformation.hpp"
#include "ecm/loop/stress.hpp"
#include "observe/reaction.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double length = 120.0; // along the pull, grips included [um]
constexpr double height = 40.0;  // [um]
constexpr double gauge = 20.0;   // half-length of the part that is measured, half a height and more from the grips [um]

/// What the middle of the specimen shows.
struct Reading {
  double strain_x;    // mean du_x/dX
  double strain_y;    // mean du_y/dY
  double stress;      // nominal, from the particles of the gauge [kPa]
  double grip_stress; // nominal, from the force on the right grip [kPa]
};

Reading read(const Simulation& a) {
  const EcmState& ecm = a.s.ecm;
  std::vector<double> X, Y, u_x, u_y;
  double P_xx = 0.0;
  const double K = moduli(a.p.ecm).K;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (std::abs(ecm.X[i].x()) > gauge) continue;
    X.push_back(ecm.X[i].x());
    Y.push_back(ecm.X[i].y());
    u_x.push_back(ecm.displacement(i).x());
    u_y.push_back(ecm.displacement(i).y());
    P_xx += piola_kirchhoff(cauchy_stress(ecm.rho[i], ecm.S[i], K), deformation_gradient(ecm, a.w.reference, i))(0, 0);
  }
  const Vec2 grip = clamp_force(a.s, a.p, a.w, [](const Vec2& at) { return at.x() > 0.0; });
  return {.strain_x = fit_slope(X, u_x),
          .strain_y = fit_slope(Y, u_y),
          .stress = P_xx / static_cast<double>(X.size()),
          .grip_stress = grip.x() / (height * a.p.ecm.thickness)};
}

/// Pulls the grips apart at a constant rate for a while, then lets the specimen come to rest.
void pull(Simulation& a, double strain, double seconds, double rest) {
  const double speed = 0.5 * strain * length / seconds;
  move_clamped(a.s.ecm, [&](const Vec2& X) { return Vec2(X.x() > 0.0 ? speed : -speed, 0.0); });
  a.march_for(seconds);
  move_clamped(a.s.ecm, [](const Vec2&) { return Vec2::Zero(); });
  a.march_for(rest);
}

draw::Picture picture(const Simulation& a) {
  draw::ParticlePicture shape{.title = "Stretch: the specimen at the last strain",
                              .value_label = "von Mises stress (Pa)",
                              .position = a.s.ecm.x,
                              .particle_size = a.p.ecm.particle_spacing};
  for (const Mat2& S : a.s.ecm.S) shape.value.push_back(1000.0 * von_mises(S));
  return {"specimen", "The gel between its grips; sides are free.", draw::to_svg(shape)};
}

} // namespace

Result stretch(const Parameters& p) {
  Result result;
  Simulation a(p, rectangle(p.ecm, length, height, 2.0 * p.ecm.smoothing_length));
  const double tau = p.ecm.viscosity / moduli(p.ecm).G;
  const double E = p.ecm.youngs_modulus, nu = p.ecm.poissons_ratio;
  const double E_plane = E / (1.0 - nu * nu); // plane strain

  result.table.columns = {"strain", "lateral_strain", "nominal_stress_Pa", "grip_stress_Pa",
                          "linear_elastic_stress_Pa"};
  Reading first{};
  for (int k = 0; k < 6; ++k) {
    pull(a, k == 0 ? 0.002 : 0.02, 2.0 * tau, 8.0 * tau);
    const Reading r = read(a);
    if (k == 0) first = r;
    result.table.add({r.strain_x, r.strain_y, 1e3 * r.stress, 1e3 * r.grip_stress, 1e3 * E_plane * r.strain_x});
  }

  const double nu_plane = -first.strain_y / first.strain_x; // nu/(1 - nu)
  const double nu_measured = nu_plane / (1.0 + nu_plane);
  const double E_measured = first.stress / first.strain_x * (1.0 - nu_measured * nu_measured);
  const double edge = p.ecm.particle_spacing / height; // a free edge is known to half a spacing on either side
  const std::string why = fmt::format("free edges known to half a spacing each: dp/height = {:.3f}, relative", edge);
  result.checks.push_back({"Young's modulus (Pa)", 1e3 * E_measured, 1e3 * E, 1e3 * E * edge, why});
  result.checks.push_back({"Poisson's ratio", nu_measured, nu, nu * edge, why});
  result.checks.push_back(
      {"stress at the grip over stress in the gauge", first.grip_stress / first.stress, 1.0, edge, why});
  const auto& last = result.table.rows.back();
  result.remarks.push_back(fmt::format(
      "At strain {:.3f} the nominal stress is {:.1f} % off the line of linear elasticity: the specimen has become "
      "thinner, and the rate form (Jaumann rate, p = K (rho - 1)) is linear only in the limit of small strain.",
      last[0], 100.0 * (last[2] / last[4] - 1.0)));
  result.add("stretch", "Quasi-static stress against strain.",
             {.title = "Stretch: uniaxial test with free sides",
              .x_label = "strain",
              .y_label = "nominal stress (Pa)",
              .series = {result.curve("linear elastic, plane strain", "strain", "linear_elastic_stress_Pa"),
                         result.curve("measured in the gauge", "strain", "nominal_stress_Pa", report::Mark::points),
                         result.curve("measured at the grip", "strain", "grip_stress_Pa", report::Mark::points)}});
  result.pictures.push_back(picture(a));
  return result;
}

} // namespace matrigrate::validation
