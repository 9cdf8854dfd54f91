#include "base/failure.hpp"
#include "ecm/law/material.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double ahead = 7.0; // of the anchor beyond the hole's edge [um]

/// A strong adhesion at 200 Pa is 0.4 nN; the load grows with the stiffness, so that the gel is strained alike [nN].
double pull(const Parameters& p) { return 2.0 * p.ecm.youngs_modulus * p.ecm.thickness; }

/// Time for which the load is held, 28 relaxation times [s].
double hold(const Parameters& p) { return 28.0 * p.ecm.viscosity / moduli(p.ecm).G; }

struct Pulled {
  report::Series travel; // of the anchored point of the gel [um] over time [s]
  std::string failure;   // why it ended early, if it did
  EcmState ecm;
};

Pulled pull_at_anchor(const Parameters& p) {
  Parameters q = p;
  q.ecm.radius = 60.0;
  q.ecm.cell_hole = true;
  Simulation a(q, disc(q));
  const Kernel kernel(q.ecm.smoothing_length);
  Vec2 anchor(q.cell.radius + q.degradation.body_distance + ahead, 0.0);
  const double start = anchor.x();
  Pulled r{.travel = {.label = "anchor", .x = {0.0}, .y = {0.0}}, .failure = {}, .ecm = {}};
  PointWeights carriers;
  const Loads load = [&](const State& s, std::span<Vec2> force) {
    carriers = solid_weights(s.ecm, kernel, anchor);
    spread(carriers, Vec2(-pull(q), 0.0), force);
  };
  try {
    a.march_for(hold(q), load, [&](const State& s) {
      anchor += q.run.time_step * interpolate(carriers, s.ecm.v);
      r.travel.add(s.t, start - anchor.x());
      return anchor.x() > 0.0; // dragged into the middle of the hole: torn out
    });
  } catch (const NumericalFailure& failure) {
    r.failure = failure.what();
  }
  r.ecm = a.s.ecm;
  return r;
}

draw::Picture picture(const EcmState& ecm) {
  draw::ParticlePicture map{
      .title = "The gel under a held pull", .value_label = "displacement (µm)", .value_min = 0.0, .value_max = 5.0};
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.f[i] <= 0.0 || ecm.X[i].norm() > 45.0) continue;
    map.position.push_back(ecm.x[i]);
    map.value.push_back(ecm.displacement(i).norm());
  }
  return {"reference", map.title + ": solid particles around the hole.", draw::to_svg(map)};
}

} // namespace

Result tearing(const Parameters& p) {
  Result result;
  const Pulled pulled = pull_at_anchor(p);
  const double dp = p.ecm.particle_spacing;
  result.table.columns = {"time_s", "travel_um"};
  const std::vector<double>& travel = pulled.travel.y;
  for (std::size_t k = 0; k < travel.size(); ++k) result.table.add({pulled.travel.x[k], travel[k]});
  const double tau = p.ecm.viscosity / moduli(p.ecm).G;
  const double left = travel.back() * std::exp(-0.8 * hold(p) / (2.0 * tau));
  result.checks.push_back(
      {"travel in the last fifth of the hold (µm)", travel.back() - travel[travel.size() * 4 / 5], 0.0,
       left + 0.01 * dp,
       "an elastic gel comes to rest: what two relaxation times mu/G leave after 22, and a hundredth of a spacing"});
  result.remarks.push_back(fmt::format("A pull of {:.3g} nN held for {:.0f} s: {:.2f} µm{}.", pull(p), hold(p),
                                       travel.back(), pulled.failure.empty() ? "" : " (" + pulled.failure + ")"));
  result.add("tearing", "The anchored point of the gel under a held pull towards the hole.",
             {.title = "Tearing: travel of an adhesion-like load",
              .x_label = "time (s)",
              .y_label = "travel of the anchor (µm)",
              .series = {pulled.travel}});
  result.pictures.push_back(picture(pulled.ecm));
  return result;
}

} // namespace matrigrate::validation
