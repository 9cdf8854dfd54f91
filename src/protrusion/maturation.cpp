#include "protrusion/maturation.hpp"

#include <algorithm>
#include <variant>

namespace matrigrate {

namespace {

constexpr int pinned = 3; // particles at either end

}

double maturing_f_mat(int steps) { return std::min(1.0, maturation_step * (steps + 1)); }

double step_force(int steps, const Parameters& p) {
  return maturation_step * (steps + p.adhesion.step_threshold) * p.actomyosin.force;
}

double final_f_mat(int steps, double F, const Parameters& p) {
  const double before = maturation_step * steps * p.actomyosin.force;
  const double part = std::clamp((F - before) / (step_force(steps, p) - before), 0.0, 1.0);
  return std::clamp(maturation_step * (steps + part), p.actomyosin.f_mat_body, 1.0);
}

void add_maturation(const State& s, const Parameters& p, std::span<Vec2> force, DragSystem& A) {
  for (const Protrusion& protrusion : s.protrusions) {
    const auto* maturing = std::get_if<Maturing>(&protrusion.phase);
    if (maturing == nullptr) continue;
    force[s.node(protrusion.centre)] -= maturing_f_mat(maturing->steps) * p.actomyosin.force * maturing->direction;
    for (int k = 0; k < pinned; ++k)
      for (const int end : {-p.protrusion.half_width + k, p.protrusion.half_width - k})
        A.diagonal[s.node(s.cortex.along(protrusion.centre, end))] += p.adhesion.base_drag;
  }
}

} // namespace matrigrate
