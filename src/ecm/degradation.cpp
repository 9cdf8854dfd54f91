#include "ecm/degradation.hpp"

#include <algorithm>

namespace matrigrate {

double degraded(double f, double rate, double dt) { return std::max(0.0, f - rate * dt); }

void fluidize(EcmState& ecm, std::size_t i) {
  ecm.f[i] = 0.0;
  ecm.S[i].setZero();
  ecm.rho[i] = 1.0;
}

std::size_t fluidize_torn(EcmState& ecm, const EcmParameters& p) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.rho[i] > p.density_min && ecm.rho[i] < p.density_max) continue;
    if (ecm.f[i] <= 0.0 || ecm.clamped[i]) continue;
    fluidize(ecm, i);
    ++count;
  }
  return count;
}

std::size_t fluidize_orphans(EcmState& ecm, const EcmParameters& p, Reference& ref) {
  std::size_t count = 0;
  for (std::size_t found = 1; found > 0; count += found) {
    ref.update(ecm);
    found = 0;
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      if (ref.relative_support(i) >= p.orphan_support || ecm.f[i] <= 0.0 || ecm.clamped[i]) continue;
      fluidize(ecm, i);
      ++found;
    }
  }
  return count;
}

} // namespace matrigrate
