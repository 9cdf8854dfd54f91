#include "base/failure.hpp"
#include "ecm/loop/stress.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"
#include "state/initial.hpp"
#include "validation/case.hpp"
#include "validation/specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace matrigrate::validation {

namespace {

/// Whether a slightly disturbed layer comes back to rest with this step.
bool stable(const Parameters& p, double dt) {
  Parameters q = p;
  q.run.time_step = dt;
  const double dp = p.ecm.particle_spacing;
  Simulation a(q, strip(q.ecm, 20 * dp, 20 * dp));
  const double size = 1e-6 * dp;
  for (std::size_t i = 0; i < a.s.ecm.size(); ++i) { // all wave lengths at once
    const double s = static_cast<double>(i);
    if (!a.s.ecm.clamped[i]) a.s.ecm.x[i] += size * Vec2(std::sin(12.9898 * s), std::sin(78.233 * s));
  }
  // displaced particles must carry the stress of their displacement, or there is nothing to return to
  SolidFields at_rest = undeformed(a.s.ecm.size());
  advance_stress(a.s.ecm, q.ecm, a.w.reference, at_rest, 1.0);
  try {
    for (int step = 0; step < 400; ++step) advance(a.s, q, dt, a.w);
  } catch (const NumericalFailure&) {
    return false;
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < a.s.ecm.size(); ++i) largest = std::max(largest, a.s.ecm.displacement(i).norm());
  return largest < 2.0 * size;
}

double measured_limit(const Parameters& p, double guess) {
  double low = 0.7 * guess, high = 1.4 * guess;
  if (!stable(p, low)) return low;
  while (high - low > 0.005 * guess) {
    const double middle = 0.5 * (low + high);
    (stable(p, middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

} // namespace

Result step_limit(const Parameters& p) {
  Result result;
  result.table.columns = {"youngs_modulus_Pa", "measured_limit_s", "analysis_s"};
  for (const double scale : {0.25, 0.5, 1.0, 2.0}) {
    Parameters q = p;
    q.ecm.youngs_modulus = scale * p.ecm.youngs_modulus;
    const double expected = step_limits(q).elastic_s;
    const double limit = measured_limit(q, expected);
    result.table.add({1e3 * q.ecm.youngs_modulus, limit, expected});
    result.checks.push_back(
        {fmt::format("largest stable step at {:.0f} Pa (s)", 1e3 * q.ecm.youngs_modulus), limit, expected,
         0.05 * expected,
         "a layer of 20 rows holds waves 5 % apart in wave number; 400 steps show growth above 0.2 % a step"});
  }
  result.remarks.push_back(describe(step_limits(p)) + ".");
  result.add("step-limit", "Steps above the line blow up.",
             {.title = "Largest stable explicit step",
              .x_label = "Young's modulus (Pa)",
              .y_label = "time step (s)",
              .log_x = true,
              .log_y = true,
              .series = {result.curve("analysis of the operators", "youngs_modulus_Pa", "analysis_s"),
                         result.curve("measured", "youngs_modulus_Pa", "measured_limit_s", report::Mark::points)}});
  return result;
}

} // namespace matrigrate::validation
