#include "contact/degrade.hpp"

#include "contact/elastic.hpp"
#include "ecm/degradation.hpp"
#include "ecm/law/material.hpp"

#include <algorithm>

namespace matrigrate {

namespace {

constexpr double in_pascals = 1000.0; // of a kPa

/// A particle of the matrix as laws see it, nearest to a place of the cortex.
LawPlace place_of(const EcmState& ecm, std::size_t k, const Degradable& e, const Parameters& p, LawPlace near) {
  near.x = ecm.x[k].x();
  near.y = ecm.x[k].y();
  near.density = ecm.rho[k];
  near.pressure = in_pascals * e.solid_pressure;
  near.f_degr = ecm.f[k];
  near.stiffness = in_pascals * p.ecm.youngs_modulus * e.stiffness;
  return near;
}

} // namespace

double degradation_pressure(double distance, double solid_pressure, const Parameters& p, double stiffness) {
  const double of_contact = stiffness * contact_pressure(distance, p);
  return std::max(solid_pressure, of_contact) + p.degradation.smaller_share * std::min(solid_pressure, of_contact);
}

double degradation_rate(const Degradable& e, const Parameters& p, const Law& law, const LawPlace& place) {
  return law({e.f, in_pascals * degradation_pressure(e.distance, e.solid_pressure, p, e.stiffness)}, place);
}

void degrade(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby, const DegradingParts& parts,
             std::span<const Vec2> tips, double dt, const Laws& laws) {
  const double K = moduli(p.ecm).K;
  const double tip_reach2 = p.degradation.tip_distance * p.degradation.tip_distance;
  for (const NearbyParticle& e : nearby) {
    const std::uint32_t k = e.particle;
    if (ecm.f[k] <= 0.0 || ecm.in_obstacle(k)) continue;
    const double stiffness = ecm.stiffness(k);
    const Degradable particle{e.distance, pressure(ecm.rho[k], K * stiffness), stiffness, ecm.f[k]};
    const bool on_protrusion = parts.on_protrusion[e.segment] != 0;
    const double reach = on_protrusion ? p.degradation.protrusion_distance : p.degradation.body_distance;
    const Law& law = on_protrusion ? laws.degradation_protrusion : laws.degradation_body;
    const LawPlace place = place_of(ecm, k, particle, p, place_at(parts.places, e.segment));
    double rate = e.distance < reach ? degradation_rate(particle, p, law, place) : 0.0;
    if (!on_protrusion && !parts.of_front.empty() && parts.of_front[e.segment] == 0) rate *= p.degradation.rear_share;
    const Vec2 x = ecm.x[k] - 0.5 * dt * ecm.v[k];
    const bool at_tip =
        std::ranges::any_of(tips, [&](const Vec2& tip) { return (x - tip).squaredNorm() < tip_reach2; });
    if (at_tip) rate = std::max(rate, degradation_rate(particle, p, laws.degradation_tip, place));
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
