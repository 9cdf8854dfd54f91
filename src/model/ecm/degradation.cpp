#include "ecm/degradation.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace matrigrate {

namespace {

/// Whether a density is not strictly between its bounds.
[[gnu::always_inline]] inline bool at_bound(double rho, double low, double high) {
  return !((rho > low) & (rho < high)); // without a branch, so that loops can be vectorised
}

/// Whether a particle is solid and has less than the minimum relative support.
[[gnu::always_inline]] inline bool is_orphan(double support, double f, double min_support) {
  return !((support >= min_support) | (f <= 0.0));
}

MATRIGRATE_SIMD
bool any_at_bound_of(std::span<const double> rho, double low, double high) {
  std::uint64_t any = 0;
  for (const double r : rho) any |= at_bound(r, low, high) ? 1U : 0U;
  return any != 0;
}

/// Whether any density is at a bound.
bool any_at_bound(const EcmState& ecm, const EcmParameters& p) {
  return parallel_any(ecm.size(), [&](std::size_t begin, std::size_t end) {
    return any_at_bound_of(std::span(ecm.rho).subspan(begin, end - begin), p.density_min, p.density_max);
  });
}

MATRIGRATE_SIMD
bool any_orphan_of(std::size_t begin, std::size_t end, const EcmState& ecm, const Reference& ref, double min_support) {
  const double* f = ecm.f.data();
  std::uint64_t any = 0;
  for (std::size_t i = begin; i < end; ++i) any |= is_orphan(ref.relative_support(i), f[i], min_support) ? 1U : 0U;
  return any != 0;
}

/// Whether any particle is an orphan.
bool any_orphan(const EcmState& ecm, const EcmParameters& p, const Reference& ref) {
  return parallel_any(ecm.size(), [&](std::size_t begin, std::size_t end) {
    return any_orphan_of(begin, end, ecm, ref, p.orphan_support);
  });
}

} // namespace

double degraded(double f, double rate, double dt) { return std::max(0.0, f - rate * dt); }

void fluidize(EcmState& ecm, std::size_t i) {
  ecm.f[i] = 0.0;
  ecm.S[i].setZero();
  ecm.rho[i] = 1.0;
}

std::size_t fluidize_torn(EcmState& ecm, const EcmParameters& p) {
  if (!any_at_bound(ecm, p)) return 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (!at_bound(ecm.rho[i], p.density_min, p.density_max) || ecm.f[i] <= 0.0 || ecm.clamped[i]) continue;
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
    if (!any_orphan(ecm, p, ref)) break;
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      if (!is_orphan(ref.relative_support(i), ecm.f[i], p.orphan_support) || ecm.clamped[i]) continue;
      fluidize(ecm, i);
      ++found;
    }
  }
  return count;
}

bool any_torn_or_orphan(const EcmState& ecm, const EcmParameters& p, Reference& ref) {
  ref.update(ecm);
  return any_at_bound(ecm, p) || any_orphan(ecm, p, ref);
}

} // namespace matrigrate
