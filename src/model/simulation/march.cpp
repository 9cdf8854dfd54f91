#include "simulation/march.hpp"

#include "simulation/adaptive.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"

namespace matrigrate {

void march(State& s, const Parameters& p, Workspace& w, double t_end, const Loads& loads,
           const std::function<bool(const State&)>& each_step) {
  require_stable_step(p, w.limits);
  const double slack = 0.5 * shortest_step(p);
  while (s.t < t_end - slack) {
    if (p.run.integrator == Integrator::adaptive)
      advance_adaptively(s, p, w, loads);
    else
      advance(s, p, p.run.time_step, w, loads);
    if (each_step && !each_step(s)) return;
  }
}

} // namespace matrigrate
