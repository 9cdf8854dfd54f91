#include "ecm/degradation.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace matrigrate {

namespace {

/// Whether any density is not strictly between the bounds.
MATRIGRATE_SIMD
bool any_at_bound(std::span<const double> rho, double low, double high) {
  std::uint64_t at_bound = 0;
  for (const double r : rho) at_bound |= (r > low) & (r < high) ? 0U : 1U;
  return at_bound != 0;
}

/// Whether any solid particle has less than the minimum relative support.
MATRIGRATE_SIMD
bool any_orphan(const EcmState& ecm, const Reference& ref, double min_support) {
  const double* f = ecm.f.data();
  std::uint64_t orphan = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    orphan |= (ref.relative_support(i) >= min_support) | (f[i] <= 0.0) ? 0U : 1U;
  return orphan != 0;
}

} // namespace

double degraded(double f, double rate, double dt) { return std::max(0.0, f - rate * dt); }

void fluidize(EcmState& ecm, std::size_t i) {
  ecm.f[i] = 0.0;
  ecm.S[i].setZero();
  ecm.rho[i] = 1.0;
}

std::size_t fluidize_torn(EcmState& ecm, const EcmParameters& p) {
  if (!any_at_bound(ecm.rho, p.density_min, p.density_max)) return 0;
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
    if (!any_orphan(ecm, ref, p.orphan_support)) break;
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      if (ref.relative_support(i) >= p.orphan_support || ecm.f[i] <= 0.0 || ecm.clamped[i]) continue;
      fluidize(ecm, i);
      ++found;
    }
  }
  return count;
}

} // namespace matrigrate
