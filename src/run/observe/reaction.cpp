#include "observe/reaction.hpp"

#include "ecm/loop/viscosity.hpp"

#include <cmath>

namespace matrigrate {

Vec2 clamp_force(const State& s, const Parameters& p, const Workspace& w,
                 const std::function<bool(const Vec2&)>& belongs) {
  const EcmState& ecm = s.ecm;
  const Kernel kernel(p.ecm.smoothing_length);
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (!ecm.clamped[i] || !belongs(ecm.X[i])) continue;
    sum += w.force[i];
    for (const std::uint32_t j : w.neighbours.pairs().of(i)) {
      if (ecm.clamped[j]) continue; // drag inside a clamp is internal to it
      const double r2 = ecm.separation(i, j).squaredNorm();
      const double G_ij =
          pair_drag(r2, kernel.W_slope(std::sqrt(r2)), ecm.V0, p.ecm.viscosity, p.ecm.thickness, kernel.h());
      sum -= G_ij * (ecm.v[i] - ecm.v[j]);
    }
  }
  return -sum;
}

} // namespace matrigrate
