#include "protrusion/adhesion.hpp"
#include "protrusion/maturation.hpp"
#include "validation/case.hpp"
#include "validation/single_protrusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace matrigrate::validation {

namespace {

constexpr double contraction = 2400.0;          // followed after the end of maturation [s]
constexpr double early = 60.0;                  // after the end of maturation [s]
constexpr double stiffest_with_rupture = 200.0; // homogeneous matrix in which the paper lets adhesions rupture [Pa]

/// One adhesion from the end of growth on, and what Eq. 7 makes of its force.
struct Life {
  report::Series relative; // force over f_mat F_am, against the time since the end of maturation [s]
  double f_mat = 0.0;      // [-]
  double length = 0.0;     // l_prot [um]
  double peak = std::numeric_limits<double>::infinity(); // of the force over mature_pull(); so if the adhesion is lost
  double lowest_early = 0.0;                             // of the relative force within `early`
  double ended_early = 1.0;                              // share of adhesions that Eq. 7 ends within `early`
  double mean_life = 0.0;                                // integral of the survival, as if the last rate went on [s]
  double slack = 0.0; // contour of the protrusion over its two sides at the end of maturation [-]
};

Life follow(const Parameters& p, store::Table& table) {
  SingleProtrusion one(p, 0.0);
  Life life;
  one.march_for(p.protrusion.growth_time + p.run.time_step);
  life.length = one.length();
  one.march_for(p.adhesion.maturation_time - p.run.time_step, [&](const State& s) {
    const auto* maturing = std::get_if<Maturing>(&one.protrusion().phase);
    if (maturing == nullptr || s.step % 10 != 0) return true;
    const double F = adhesion_force(one.cell().cortex, one.protrusion(), p.adhesion);
    const double F_mat = maturing_f_mat(maturing->steps) * p.actomyosin.force;
    table.add({1e3 * p.ecm.youngs_modulus, s.t, F, F / F_mat, one.slack(0), one.base_width(0)});
    return true;
  });
  while (std::holds_alternative<Maturing>(one.protrusion().phase)) one.march_for(p.run.time_step);
  const auto* contracting = std::get_if<Contracting>(&one.protrusion().phase);
  if (contracting == nullptr) return life; // lost
  life.f_mat = contracting->f_mat;
  life.peak = 0.0;
  life.lowest_early = 1.0;
  life.slack = one.slack(0);
  const double pull = life.f_mat * p.actomyosin.force;
  const double begin = one.state().t;
  double before = begin;
  double survival = 1.0;
  one.march_for(contraction, [&](const State& s) {
    const double F = adhesion_force(one.cell().cortex, one.protrusion(), p.adhesion);
    const double t = s.t - begin;
    const double rate = disassembly_rate(F, life.f_mat, p.adhesion);
    life.mean_life += survival * (s.t - before);
    survival *= std::exp(-rate * (s.t - before));
    before = s.t;
    life.peak = std::max(life.peak, F / mature_pull(life.f_mat, p));
    if (t <= early) {
      life.lowest_early = std::min(life.lowest_early, F / pull);
      life.ended_early = 1.0 - survival;
    }
    if (s.step % 10 == 0 || t < 20.0) {
      life.relative.x.push_back(t);
      life.relative.y.push_back(F / pull);
      table.add({1e3 * p.ecm.youngs_modulus, s.t, F, F / pull, one.slack(0), one.base_width(0)});
    }
    return std::holds_alternative<Contracting>(one.protrusion().phase);
  });
  if (life.relative.y.empty()) return life;
  const double last = disassembly_rate(life.relative.y.back() * pull, life.f_mat, p.adhesion);
  life.mean_life += survival / last;
  return life;
}

} // namespace

Result handover(const Parameters& p) {
  Result result;
  result.table.columns = {"E_Pa", "time_s", "force_nN", "force_over_pull", "slack", "base_width_um"};
  report::Plot plot{.title = "Force of a lone adhesion after maturation",
                    .x_label = "time since the end of maturation (s)",
                    .y_label = "force over f_mat F_am"};
  for (const double E : {50.0, 200.0, 400.0}) {
    Parameters q = p;
    q.ecm.youngs_modulus = 1e-3 * E;
    const Life life = follow(q, result.table);
    plot.series.push_back({.label = fmt::format("{:.0f} Pa", E), .x = life.relative.x, .y = life.relative.y});
    result.checks.push_back({fmt::format("length of the protrusion at {:.0f} Pa (µm)", E), life.length, 27.5, 5.0,
                             "the paper's 25 to 30 µm are means over whole runs"});
    const double by_chance = -std::expm1(-p.adhesion.r_off_min * early);
    result.checks.push_back({fmt::format("adhesions that end within {:.0f} s at {:.0f} Pa", early, E), life.ended_early,
                             2.0 * by_chance, 0.0, "twice what r_off_min alone ends", Sense::at_most});
    result.checks.push_back({fmt::format("least force over f_mat F_am within {:.0f} s at {:.0f} Pa", early, E),
                             life.lowest_early, 0.5, 0.0, "F_mat is replaced, not taken away", Sense::at_least});
    if (E <= stiffest_with_rupture)
      result.checks.push_back({fmt::format("largest force over that of rupture at {:.0f} Pa", E), life.peak, 1.0, 0.0,
                               "its own pull ruptures an adhesion only occasionally", Sense::at_most});
    result.remarks.push_back(
        fmt::format("{:.0f} Pa: f_mat {:.3f}, slack of the flanks {:.2f}; force over f_mat F_am "
                    "at least {:.2f} within {:.0f} s, at most {:.2f} times that of rupture in all; mean life "
                    "{:.1f} min.",
                    E, life.f_mat, life.slack, life.lowest_early, early, life.peak, life.mean_life / 60.0));
  }
  result.add("handover", "F_mat is replaced by the contraction of the cortex; then the body follows.", plot);
  return result;
}

} // namespace matrigrate::validation
