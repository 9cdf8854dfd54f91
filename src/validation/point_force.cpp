#include "ecm/law/material.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/closed_forms.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double pull = 0.06;   // [nN]
constexpr double radius = 80.0; // of the disc [um]

Simulation pulled_disc(const Parameters& p, double E) {
  Parameters q = with_disc(p, radius);
  q.ecm.youngs_modulus = E;
  Simulation a(q, disc(q));
  const PointWeights centre = solid_weights(a.s.ecm, Kernel(q.ecm.smoothing_length), Vec2::Zero());
  a.march_for(12.0 * q.ecm.viscosity / moduli(q.ecm).G,
              [&](const State&, std::span<Vec2> force) { spread(centre, Vec2(pull, 0.0), force); });
  return a;
}

/// The closed form with clamp radius a [um].
Vec2 exact(const EcmParameters& p, const Vec2& X, double a) {
  return clamped_disc_displacement(Vec2(pull / p.thickness, 0.0), X, a, moduli(p).G, p.poissons_ratio);
}

/// Root-mean-square difference of displacements u(i) from the closed form, over it, from four smoothing lengths off the
/// load to half the radius.
template <class Displacement>
double difference(const Simulation& s, const Displacement& u) {
  const double a = clamp_radius(s.p.ecm);
  double square = 0.0, field = 0.0;
  for (std::size_t i = 0; i < s.s.ecm.size(); ++i) {
    const Vec2& X = s.s.ecm.X[i];
    if (X.norm() < 4.0 * s.p.ecm.smoothing_length || X.norm() > 0.5 * a) continue;
    const Vec2 closed = exact(s.p.ecm, X, a);
    square += (u(i) - closed).squaredNorm();
    field += closed.squaredNorm();
  }
  return std::sqrt(square / field);
}

/// Displacement of the point that carries the load [um].
double point_displacement(const Simulation& s) {
  const PointWeights centre = solid_weights(s.s.ecm, Kernel(s.p.ecm.smoothing_length), Vec2::Zero());
  std::vector<Vec2> u(s.s.ecm.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = s.s.ecm.displacement(i);
  return interpolate(centre, u).x();
}

draw::Picture picture(const Simulation& s) {
  draw::ParticlePicture map{
      .title = fmt::format("Point force of {} pN: displacement at {:.0f} Pa", 1e3 * pull, 1e3 * s.p.ecm.youngs_modulus),
      .value_label = "displacement (µm)",
      .position = s.s.ecm.x,
      .particle_size = s.p.ecm.particle_spacing};
  for (std::size_t i = 0; i < s.s.ecm.size(); ++i) map.value.push_back(s.s.ecm.displacement(i).norm());
  return {"map", "The gel under a kernel-distributed force to the right; the rim is clamped.", draw::to_svg(map)};
}

} // namespace

Result point_force(const Parameters& p) {
  Result result;
  result.table.columns = {"youngs_modulus_Pa", "distance_um", "displacement_um", "closed_form_um"};
  report::Plot plot{.title = "Point force in a clamped disc",
                    .x_label = "distance along the force (µm)",
                    .y_label = "displacement along the force (µm)",
                    .log_y = true};
  std::vector<double> compliance;
  for (const double scale : {0.25, 0.5, 1.0, 2.0}) {
    const double E = scale * p.ecm.youngs_modulus;
    const Simulation s = pulled_disc(p, E);
    const double a = clamp_radius(s.p.ecm);
    const std::string label = fmt::format("{:.0f} Pa", 1e3 * E);
    const double error = difference(s, [&](std::size_t i) { return s.s.ecm.displacement(i); });
    const double clamp =
        difference(s, [&](std::size_t i) { return exact(s.p.ecm, s.s.ecm.X[i], a + s.p.ecm.particle_spacing); });
    result.checks.push_back(
        {"field error at " + label, error, 0.0, clamp + 1.0 / 16.0,
         fmt::format("clamp known to a spacing: {:.3f}; load spread over h, read from 4h on: (1/4)^2", clamp)});
    const auto colour = static_cast<int>(compliance.size());
    compliance.push_back(point_displacement(s) * E);
    report::Series measured{.label = label + ", measured", .mark = report::Mark::points, .colour = colour};
    report::Series closed{.label = label + ", closed form", .colour = colour};
    for (std::size_t i = 0; i < s.s.ecm.size(); ++i) {
      const Vec2& X = s.s.ecm.X[i];
      if (std::abs(X.y()) > 1e-9 || X.x() <= 0.0 || s.s.ecm.clamped[i]) continue;
      const double u = s.s.ecm.displacement(i).x();
      const double ideal = exact(s.p.ecm, X, a).x();
      result.table.add({1e3 * E, X.x(), u, ideal});
      measured.add(X.x(), u);
      closed.add(X.x(), ideal);
    }
    plot.series.insert(plot.series.end(), {measured, closed});
    if (scale == 1.0) result.pictures.push_back(picture(s));
  }
  const double u_max = compliance.front() / (0.25 * p.ecm.youngs_modulus);
  const double strain = u_max / (2.0 * p.ecm.smoothing_length);
  result.checks.push_back({"displacement of the loaded point times E, softest over stiffest gel",
                           compliance.front() / compliance.back(), 1.0, strain,
                           "linear elasticity gives 1; the softest gel is strained by about u/2h at the load"});
  const double continuum = continuum_compliance(with_disc(p, radius).ecm, p.ecm.smoothing_length);
  const double measured = compliance[2] / p.ecm.youngs_modulus / pull;
  result.remarks.push_back(fmt::format(
      "Compliance of the loaded point at {:.0f} Pa: {:.3f} µm/nN, {:.3f} times the continuum, {:.3f} µm/nN, loaded and "
      "read with the same kernel: an adhesion feels a gel that is softer by as much, at every stiffness.",
      1e3 * p.ecm.youngs_modulus, measured, measured / continuum, continuum));
  result.add("point-force", "Displacement along the line of the force.", plot);
  return result;
}

} // namespace matrigrate::validation
