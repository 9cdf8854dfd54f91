#include "base/random.hpp"
#include "protrusion/life_cycle.hpp"
#include "statistics/distributions.hpp"
#include "validation/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace matrigrate::validation {

namespace {

constexpr double f_mat = 0.5;                           // of the paper's Fig 4
constexpr std::array<double, 3> zeta{20.0, 40.0, 80.0}; // [1/nN]: 2e4, 4e4, 8e4 um/N of the paper
constexpr std::uint32_t adhesions = 2000;

/// Force at which the rate has fallen to twice its least, from the curve.
double force_of_half_life(const Law& rate, double least) {
  double low = 0.0, high = 10.0;
  for (int k = 0; k < 60; ++k) {
    const double F = 0.5 * (low + high);
    (rate({F, f_mat, 0.0}) > 2.0 * least ? low : high) = F;
  }
  return low;
}

/// Lifetimes of adhesions that contract under a constant force, step by step through the transition table [s].
std::vector<double> lifetimes(const Parameters& p, double F) {
  std::vector<double> lives;
  const Laws laws(p);
  for (std::uint32_t id = 1; id <= adhesions; ++id) {
    std::uint64_t step = 0;
    const Phase phase = Contracting{Vec2::Zero(), f_mat};
    for (Transition change; !change.changes;) {
      ++step;
      const Circumstances now{.force = F, .support = 1.0, .draw = uniform(p.run.seed, Purpose::disassembly, step, id)};
      change = transition(phase, now, p, p.run.time_step, laws);
    }
    lives.push_back((static_cast<double>(step) - 0.5) * p.run.time_step);
  }
  return lives;
}

} // namespace

Result disassembly(const Parameters& p) {
  Result result;
  result.table.columns = {"zeta_diss_per_nN", "force_nN", "r_off_per_s", "lifetime_min"};
  report::Plot plot{.title = "Lifetime of an adhesion, f_mat = 0.5",
                    .x_label = "force of the adhesion (nN)",
                    .y_label = "mean lifetime of the adhesion, 1/r_off (min)"};
  for (const double z : zeta) {
    Parameters other = p;
    other.adhesion.zeta_diss = z;
    const Law r_off("laws.disassembly_rate", other);
    report::Series& curve = plot.series.emplace_back(report::Series{.label = fmt::format("zeta_diss = {:.0f} /nN", z)});
    double lifetime = 0.0; // [min]
    double least_rise = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 120; ++k) {
      const double F = 0.0025 * k;
      const double rate = r_off({F, f_mat, 0.0});
      least_rise = std::min(least_rise, 1.0 / rate / 60.0 - lifetime);
      lifetime = 1.0 / rate / 60.0;
      result.table.add({z, F, rate, lifetime});
      curve.add(F, lifetime);
    }
    result.claims.push_back({fmt::format("lifetime at f_mat F_am = 0.3 nN, zeta_diss = {:.0f} /nN (min)", z), lifetime,
                             60.0, 0.6, "the paper's Fig 4: it tends to 60 min at high force"});
    result.checks.push_back(
        {fmt::format("least rise of the lifetime from force to force, zeta_diss = {:.0f} /nN (min)", z), least_rise,
         0.0, 0.0, "Eq. 7: lives shorten with the strength of a cell only if it loads its adhesions less",
         Sense::at_least});
    result.checks.push_back({fmt::format("force that gives half of that, zeta_diss = {:.0f} /nN (nN)", z),
                             force_of_half_life(r_off, p.adhesion.r_off_min),
                             f_mat * std::log(p.adhesion.r_off_0 / p.adhesion.r_off_min) / z, 1e-9,
                             "closed form of Eq. 7"});
  }
  for (const double F : {0.05, 0.1}) {
    const double rate = Law("laws.disassembly_rate", p)({F, f_mat, 0.0});
    const std::vector<double> lives = lifetimes(p, F);
    const double mean = std::accumulate(lives.begin(), lives.end(), 0.0) / adhesions;
    result.checks.push_back({fmt::format("mean lifetime of {} adhesions at {:.2f} nN, times r_off", adhesions, F),
                             mean * rate, 1.0, 3.0 / std::sqrt(adhesions), "three standard errors"});
    result.checks.push_back({fmt::format("Kolmogorov-Smirnov statistic D sqrt(n) of these against the exponential"),
                             kolmogorov_smirnov_exponential(lives, rate), 0.0, one_in_a_hundred,
                             "exceeded by one exponential sample in a hundred"});
  }
  result.add("disassembly", "Eq. 7 for the three sensitivities of the paper's Fig 4.", plot);
  return result;
}

} // namespace matrigrate::validation
