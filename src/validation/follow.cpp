#include "cell/geometry.hpp"
#include "contact/degrade.hpp"
#include "contact/elastic.hpp"
#include "contact/proximity.hpp"
#include "ecm/law/material.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/membership.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <variant>

namespace matrigrate::validation {

namespace {

constexpr double follow_time = 5400.0;      // after maturation [s]
constexpr double interval = 60.0;           // of the table [s]
constexpr double judged = 3600.0;           // when a strong protrusion should have drawn its body along [s]
constexpr double strong = 0.8, weak = 0.35; // f_mat [-]

/// Solid at the body of the cell, not at its protrusions, within the reach of degradation.
struct Front {
  int solid = 0;       // particles
  int degrading = 0;   // of them under more than p_th
  double pressure = 0; // largest that is compared with p_th [kPa]
};

Front front(const State& s, const Parameters& p) {
  const Cell& cell = s.cells.front();
  const double reach = p.degradation.body_distance;
  const Membership m = membership(cell, p);
  Front found;
  for (const NearbyParticle& e : nearby_solid(s.ecm, cell.cortex, SegmentGrid(cell.cortex, reach), reach)) {
    if (m.on_protrusion[e.segment] != 0 || e.distance >= reach) continue;
    const double stiffness = s.ecm.stiffness(e.particle);
    const double of_solid = pressure(s.ecm.rho[e.particle], moduli(p.ecm).K * stiffness);
    const double compared = degradation_pressure(e.distance, of_solid, p, stiffness);
    ++found.solid;
    if (compared > p.degradation.threshold) ++found.degrading;
    found.pressure = std::max(found.pressure, compared);
  }
  return found;
}

struct Followed {
  double f_mat = 0.0;  // [-]
  double force = 1.0;  // of the adhesion over mature_pull(), at `judged` [-]
  double length = 0.0; // of the protrusion then [um]
  double moved = 0.0;  // of the centroid since the end of growth, in the end [um]
  double last = 0.0;   // of it in the last ten minutes [um]
  Front front;         // in the end
  report::Series path, pull;
};

Followed follow_one(const Parameters& p, store::Table& table) {
  Parameters q = p;
  q.run.integrator = Integrator::adaptive;
  q.run.time_step = usual_time_step(q.run.integrator);
  const Laws laws(q);
  SingleProtrusion one(q, 0.0);
  one.march_for(q.protrusion.growth_time + q.run.time_step);
  const Vec2 start = centroid(one.cell().cortex);
  while (std::holds_alternative<Maturing>(one.protrusion().phase)) one.march_for(q.run.time_step);
  Followed found;
  const auto* contracting = std::get_if<Contracting>(&one.protrusion().phase);
  if (contracting == nullptr) return found; // the adhesion was lost
  found.f_mat = contracting->f_mat;
  const double full = mature_pull(found.f_mat, q);
  for (double t = 0.0; t < follow_time; t += interval) {
    one.march_for(interval);
    const double F = adhesion_force(one.cell().cortex, one.protrusion(), q.adhesion, laws);
    const double before = found.moved;
    found.moved = (centroid(one.cell().cortex) - start).norm();
    if (t < judged) {
      found.force = F / full;
      found.length = one.length();
    }
    if (t >= follow_time - 600.0) found.last += found.moved - before;
    found.path.add((t + interval) / 60.0, found.moved);
    found.pull.add((t + interval) / 60.0, F / full);
    found.front = front(one.s, q);
    table.add({1e3 * q.ecm.youngs_modulus, q.actomyosin.force, found.f_mat, t + interval, found.moved, F, one.length(),
               static_cast<double>(found.front.solid), static_cast<double>(found.front.degrading),
               1e3 * found.front.pressure});
  }
  return found;
}

} // namespace

Result follow(const Parameters& p) {
  Result result;
  result.table.columns = {"E_Pa",     "F_am_nN",   "f_mat",          "time_s",    "moved_um",
                          "force_nN", "length_um", "solid_at_front", "degrading", "front_pressure_Pa"};
  report::Plot path{.title = "The body follows its adhesion",
                    .x_label = "time since the end of maturation (min)",
                    .y_label = "displacement since the end of growth (µm)"};
  report::Plot pull{.title = "Force of the adhesion",
                    .x_label = "time since the end of maturation (min)",
                    .y_label = "force over 2 f_mat F_am"};
  constexpr std::array<std::pair<double, double>, 7> settings{
      // E [Pa], F_am [nN]
      {{50, 0.6}, {100, 0.6}, {200, 0.6}, {400, 0.6}, {200, 0.4}, {200, 1.2}, {200, 2.0}}};
  for (const auto& [E, F_am] : settings) {
    Parameters q = p;
    q.ecm.youngs_modulus = 1e-3 * E;
    q.actomyosin.force = F_am;
    Followed one = follow_one(q, result.table);
    const std::string label = fmt::format("{:.0f} Pa, F_am {:.1f} nN", E, F_am);
    if (one.path.x.empty()) {
      result.remarks.push_back(label + ": the adhesion was lost.");
      continue;
    }
    const std::string force =
        fmt::format("force over 2 f_mat F_am {:.0f} min after maturation at {}", judged / 60.0, label);
    if (E == 200.0 && F_am == 0.6) {
      result.checks.push_back({"displacement of the body at " + label + " (µm)", one.moved, 5.0, 0.0,
                               "a cell moves by its adhesions", Sense::at_least});
      result.checks.push_back({"displacement in the last ten minutes at " + label + " (µm)", one.last, 0.0, 1.0,
                               "the body comes to rest, at its adhesion or at the gel"});
      if (one.f_mat >= strong)
        result.claims.push_back({force, one.force, 0.1, 0.0,
                                 "F_adh \"decreases only when the protrusion shortens\", and the gel hinders little",
                                 Sense::at_most});
    }
    if (one.f_mat <= weak)
      result.claims.push_back({force, one.force, 0.1, 0.0,
                               "a weak pull stays under p_th, so that the gel carries the body", Sense::at_least});
    result.remarks.push_back(fmt::format(
        "{}: f_mat {:.2f}; moved {:.1f} µm, of it {:.1f} in the last ten minutes; {:.0f} min after maturation the "
        "adhesion bears {:.3f} of f_mat F_am and the protrusion is {:.1f} µm long. In the end {} solid particles are "
        "within reach of the body, {} of them under more than p_th; the largest pressure is {:.1f} Pa.",
        label, one.f_mat, one.moved, one.last, judged / 60.0, one.force, one.length, one.front.solid,
        one.front.degrading, 1e3 * one.front.pressure));
    one.path.label = one.pull.label = label;
    path.series.push_back(std::move(one.path));
    pull.series.push_back(std::move(one.pull));
  }
  result.add("follow", "An adhesion that never lets go: the body follows until it or the gel bears the pull.", path);
  result.add("follow-force", "What the adhesion bears; what it does not, the gel at the front does.", pull);
  return result;
}

} // namespace matrigrate::validation
