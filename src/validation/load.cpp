#include "ecm/law/material.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace matrigrate::validation {

namespace {

constexpr double small = 0.02;           // load in the linear range [nN]
const Vec2 site(0.37, 0.71);             // of the load, at no particular place of the lattice [um]
constexpr double times_mu_over_G = 18.0; // after which the point is at rest

struct Loaded {
  double compliance = 0.0; // displacement of the point over the load, at rest [um/nN]
  double t_98 = 0.0;       // until 98 % of it [s]
};

/// A constant load on a point of a disc, spread and read with the kernel of adhesions.
Loaded loaded(const Parameters& p, double pull) {
  Parameters q = p;
  q.run.integrator = Integrator::adaptive; // halves its steps where a large weight of the penalty asks for it
  Simulation a(q, disc(q));
  const Kernel kernel(q.adhesion.spread * q.ecm.smoothing_length);
  double x = site.x(); // of the point
  const auto weights = [&](const State& s) { return material_weights(s.ecm, kernel, site); };
  double before = 0.0;
  report::Series path;
  a.march_for(
      times_mu_over_G * q.ecm.viscosity / moduli(q.ecm).G,
      [&](const State& s, std::span<Vec2> force) { spread(weights(s), Vec2(pull, 0.0), force); },
      [&](const State& s) {
        x += (s.t - before) * interpolate(weights(s), s.ecm.v).x();
        before = s.t;
        path.add(s.t, x - site.x());
        return true;
      });
  Loaded result{.compliance = path.y.back() / pull};
  for (std::size_t k = 0; k < path.x.size() && path.y[k] < 0.98 * path.y.back(); ++k) result.t_98 = path.x[k];
  return result;
}

/// Of the continuum under the same load [um/nN].
double continuum(const Parameters& p) {
  return continuum_compliance(p.ecm, p.adhesion.spread * p.ecm.smoothing_length);
}

Parameters with(Parameters p, double spread, double weight) {
  p.adhesion.spread = spread;
  p.ecm.hourglass_weight = weight;
  return p;
}

} // namespace

Result load(const Parameters& given) {
  const Parameters p = with_disc(given, 80.0);
  Result result;
  result.table.columns = {"spread", "hourglass_weight", "load_nN", "compliance_um_per_nN", "continuum_um_per_nN",
                          "t_98_s"};
  const auto measure = [&](const Parameters& q, double pull) {
    const Loaded found = loaded(q, pull);
    result.table.add({q.adhesion.spread, q.ecm.hourglass_weight, pull, found.compliance, continuum(q), found.t_98});
    return found;
  };
  report::Plot of_weight{.title = "Compliance against the hourglass weight",
                         .x_label = "hourglass weight",
                         .y_label = "compliance over the continuum",
                         .log_x = true};
  constexpr std::array weights{0.5, 2.0, 10.0};
  for (const double spread : {1.0, 1.5, 2.0, 2.5}) {
    report::Series series{.label = fmt::format("kernel {:.1f} µm", spread * p.ecm.smoothing_length)};
    for (const double weight : weights) {
      const Parameters q = with(p, spread, weight);
      series.add(weight, measure(q, small).compliance / continuum(q));
    }
    const double change = series.y.front() / series.y.back() - 1.0;
    if (spread == 2.5) {
      result.checks.push_back({"compliance over the continuum, kernel of 2.5 times the width", series.y.front(), 1.0,
                               0.05, "a load that is resolved: an adhesion feels the gel within a twentieth"});
      result.checks.push_back({"its change from weight 0.5 to 10", change, 0.0, 0.03,
                               "the penalty has no physics, so a resolved load must not feel it"});
    }
    result.remarks.push_back(fmt::format("Kernel of {:.1f} µm: {:.3f} times the compliance of the continuum at weight "
                                         "0.5; {:.3f} times as much at 0.5 as at 10.",
                                         spread * p.ecm.smoothing_length, series.y.front(), 1.0 + change));
    of_weight.series.push_back(std::move(series));
  }
  const Parameters usual = with(p, 1.0, p.ecm.hourglass_weight);
  const double linear = loaded(usual, small).compliance;
  report::Series series{.label = "held by matter"};
  for (const double pull : {small, 0.3, 0.6, 1.2, 2.0}) series.add(pull, measure(usual, pull).compliance / linear);
  result.checks.push_back({"compliance at 2 nN over that at 0.02 nN, held by matter", series.y.back(), 1.0, 0.05,
                           "linear but for what strains of order one add"});
  result.remarks.push_back(
      fmt::format("{:.3f} times the small compliance at 0.6 nN, {:.3f} times at 2 nN.", series.y[2], series.y.back()));
  result.add("load", "A wider kernel loads modes that the sums over neighbours resolve.", of_weight);
  result.add("load-force", "An adhesion that hangs on matter does not slip through the gel.",
             {.title = "Compliance against the load",
              .x_label = "load (nN)",
              .y_label = "compliance over its value at a small load",
              .log_x = true,
              .series = {series}});
  return result;
}

} // namespace matrigrate::validation
