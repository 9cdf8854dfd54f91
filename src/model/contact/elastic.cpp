#include "contact/elastic.hpp"

#include "ecm/law/material.hpp"

namespace matrigrate {

double contact_pressure(double distance, const Parameters& p) {
  return distance < p.contact.range ? moduli(p.ecm).K * (1.0 - distance / p.contact.range) : 0.0;
}

void add_elastic_contact(const EcmState& ecm, const CortexState& c, const Parameters& p,
                         std::span<const NearbyParticle> nearby, double dt, std::uint32_t first, std::span<Vec2> force,
                         NodeForces& on_matrix, DragSystem& A) {
  const double width = p.ecm.particle_spacing * p.ecm.thickness; // [um^2] a unit of pressure acts on
  const double stiffness = moduli(p.ecm).K * width / p.contact.range;
  for (const NearbyParticle& e : nearby) {
    if (e.distance >= p.contact.range) continue;
    const bool rigid = ecm.in_obstacle(e.particle);
    const double f = rigid ? obstacle_contact : ecm.f[e.particle] * ecm.stiffness(e.particle);
    const std::uint32_t a = first + e.segment;
    const std::uint32_t b = first + static_cast<std::uint32_t>(c.next(e.segment));
    const Vec2 F = f * contact_pressure(e.distance, p) * width * e.normal;
    on_matrix.add(e.particle, F);
    force[a] -= (1.0 - e.s) * F;
    force[b] -= e.s * F;
    if (!rigid) A.directed.add_entry(e.particle, e.normal);
    A.directed.add_entry(a, -(1.0 - e.s) * e.normal);
    A.directed.add_entry(b, -e.s * e.normal);
    A.directed.close(dt * f * stiffness);
  }
}

} // namespace matrigrate
