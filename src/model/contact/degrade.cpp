#include "contact/degrade.hpp"

#include "contact/elastic.hpp"
#include "ecm/degradation.hpp"
#include "ecm/law/material.hpp"

#include <algorithm>

namespace matrigrate {

double degradation_pressure(double distance, double solid_pressure, const Parameters& p, double stiffness) {
  const double of_contact = stiffness * contact_pressure(distance, p);
  return std::max(solid_pressure, of_contact) + p.degradation.smaller_share * std::min(solid_pressure, of_contact);
}

double degradation_rate(double distance, bool on_protrusion, double solid_pressure, const Parameters& p,
                        double stiffness) {
  const double reach = on_protrusion ? p.degradation.protrusion_distance : p.degradation.body_distance;
  if (distance >= reach) return 0.0;
  if (degradation_pressure(distance, solid_pressure, p, stiffness) <= p.degradation.threshold) return 0.0;
  return on_protrusion ? p.degradation.protrusion_rate : p.degradation.body_rate;
}

void degrade(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby, const DegradingParts& parts,
             std::span<const Vec2> tips, double dt) {
  const double K = moduli(p.ecm).K;
  const double tip_reach2 = p.degradation.tip_distance * p.degradation.tip_distance;
  for (const NearbyParticle& e : nearby) {
    const std::uint32_t k = e.particle;
    if (ecm.f[k] <= 0.0 || ecm.in_obstacle(k)) continue;
    const double stiffness = ecm.stiffness(k);
    const bool on_protrusion = parts.on_protrusion[e.segment] != 0;
    double rate = degradation_rate(e.distance, on_protrusion, pressure(ecm.rho[k], K * stiffness), p, stiffness);
    if (!on_protrusion && !parts.of_front.empty() && parts.of_front[e.segment] == 0) rate *= p.degradation.rear_share;
    const Vec2 x = ecm.x[k] - 0.5 * dt * ecm.v[k];
    const bool at_tip =
        std::ranges::any_of(tips, [&](const Vec2& tip) { return (x - tip).squaredNorm() < tip_reach2; });
    if (at_tip) rate = std::max(rate, p.degradation.tip_rate);
    if (rate <= 0.0) continue;
    ecm.f[k] = degraded(ecm.f[k], rate, dt);
    if (ecm.f[k] <= 0.0) fluidize(ecm, k);
  }
}

std::size_t fluidize_engulfed(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby) {
  std::size_t count = 0;
  for (const NearbyParticle& e : nearby) {
    if (ecm.f[e.particle] <= 0.0 || e.distance >= -p.contact.deepest_solid || ecm.in_obstacle(e.particle)) continue;
    fluidize(ecm, e.particle);
    ++count;
  }
  return count;
}

} // namespace matrigrate
