#include "simulation/step_limits.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace matrigrate::validation {

namespace {

constexpr std::array<double, 5> steps{0.1, 0.2, 0.4, 0.8, 1.6}; // of the reference integrator [s]
constexpr std::array<double, 3> adaptive_steps{0.5, 2.0, 5.0};  // the longest of the adaptive one [s]
constexpr double paper_step = 0.4;                              // [s]
constexpr std::array<double, 4> times{16.0, 32.0, 48.0, 96.0};  // [s]
constexpr std::size_t early = 3; // times: later the deflection of growth makes much of small differences
constexpr int directions = 16;

constexpr double angle = 0.3; // of the protrusion that is followed [rad]

using Tips = std::array<Vec2, times.size()>; ///< of the protrusion at the times [um]

Parameters stepped(Parameters p, Integrator integrator, double dt) {
  p.run.integrator = integrator;
  p.run.time_step = dt;
  return p;
}

Tips tips_of(const Parameters& p) {
  SingleProtrusion one(p, angle);
  Tips tips;
  for (std::size_t k = 0; k < times.size(); ++k) {
    one.march(times[k]);
    tips[k] = one.cell().cortex.x[one.protrusion().centre];
  }
  return tips;
}

/// Largest distance along the direction of growth over the first `count` times [um]. Across it the deflection of growth
/// makes much of small differences at once (MODEL.md, I17).
double distance(const Tips& a, const Tips& b, std::size_t count) {
  const Vec2 along(std::cos(angle), std::sin(angle));
  double largest = 0.0;
  for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, std::abs((a[k] - b[k]).dot(along)));
  return largest;
}

/// l_prot at the end of growth, mean over directions [um].
double mean_length(const Parameters& p) {
  const double dt = p.run.time_step;
  double sum = 0.0;
  for (int k = 0; k < directions; ++k) {
    SingleProtrusion one(p, 0.1 + 2.0 * std::numbers::pi * k / directions);
    one.march_for(dt * std::ceil(p.protrusion.growth_time / dt + 1.0));
    sum += one.protrusion().record.length;
  }
  return sum / directions;
}

} // namespace

Result time_step(const Parameters& p) {
  Result result;
  result.table.columns = {"adaptive", "time_step_s", "early_error_um", "error_um"};
  const Tips finest = tips_of(stepped(p, Integrator::reference, steps.front()));
  std::vector<double> early_errors; // of the reference integrator first
  const auto errors = [&](Integrator integrator, std::span<const double> all, const std::string& label) {
    report::Series series{.label = label};
    for (const double dt : all) {
      const Tips tips = tips_of(stepped(p, integrator, dt));
      series.add(dt, distance(tips, finest, tips.size()));
      early_errors.push_back(distance(tips, finest, early));
      result.table.add({integrator == Integrator::adaptive ? 1.0 : 0.0, dt, early_errors.back(), series.y.back()});
    }
    return series;
  };
  const report::Series reference = errors(Integrator::reference, std::span(steps).subspan(1), "reference");
  const report::Series adaptive = errors(Integrator::adaptive, adaptive_steps, "adaptive");
  const double quarter = 0.25 * p.ecm.particle_spacing;
  result.checks.push_back({fmt::format("tip, reference, up to {:.0f} s: error with steps of {} s over that of {} s",
                                       times[early - 1], reference.x.front(), reference.x.back()),
                           early_errors.front() / early_errors[reference.x.size() - 1], 0.5, 0.0,
                           "it falls with the step; errors of opposite sign leave no clean order", Sense::at_most});
  for (std::size_t k = 0; k < reference.x.size(); ++k)
    if (reference.x[k] <= paper_step)
      result.checks.push_back({fmt::format("tip, reference steps of {} s (µm)", reference.x[k]), reference.y[k], 0.0,
                               quarter, "a quarter of a spacing, of the way of 23 µm"});
  for (std::size_t k = 0; k < adaptive.x.size(); ++k)
    result.checks.push_back({fmt::format("tip, adaptive steps of up to {} s (µm)", adaptive.x[k]), adaptive.y[k], 0.0,
                             quarter, "a quarter of a spacing, of the way of 23 µm"});
  const double usual = usual_time_step(Integrator::adaptive);
  result.checks.push_back(
      {fmt::format("l_prot, adaptive steps of up to {} s, mean over {} directions (µm)", usual, directions),
       mean_length(stepped(p, Integrator::adaptive, usual)), mean_length(stepped(p, Integrator::reference, paper_step)),
       quarter, fmt::format("that with reference steps of {} s; a quarter of a spacing", paper_step)});
  result.remarks.push_back(
      fmt::format("Errors are distances of the tip from that with steps of {} s along the direction of growth, the "
                  "largest at {:.0f}, {:.0f}, {:.0f} and {:.0f} s. Across it, and later along it, the deflection of "
                  "growth makes much of small differences.",
                  steps.front(), times[0], times[1], times[2], times[3]));
  result.add("time-step", "Distance of the tip from where the shortest steps bring it.",
             {.title = "A protrusion with longer steps",
              .x_label = "time step (s)",
              .y_label = "distance of the tip (µm)",
              .series = {reference, adaptive}});
  return result;
}

} // namespace matrigrate::validation
