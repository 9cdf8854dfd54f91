#pragma once

#include "contact/proximity.hpp"
#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

/// The cell degrades the solid around it (Heck et al. 2020, section "Degradation"; MODEL.md, I15).
/// Test: tests/unit/contact/degrade_test.cpp
namespace matrigrate {

/// The pressure that is compared with p_th [kPa]: the larger of those of solid and contact, and smaller_share of the
/// smaller one.   @param distance  to the closest segment [um]
double degradation_pressure(double distance, double solid_pressure, const Parameters& p, double stiffness = 1.0);

/// A particle that may be degraded.
struct Degradable {
  double distance;        ///< to the closest segment [um]
  double solid_pressure;  ///< [kPa]
  double stiffness = 1.0; ///< E_k/E, which scales the contact pressure [-]
  double f = 1.0;         ///< intact fraction [-]
};

/// A law of degradation at a particle, of its intact fraction and degradation_pressure() [1/s].
double degradation_rate(const Degradable& e, const Parameters& p, const Law& law, const LawPlace& place = {});

/// Parts of the cortex that degrade at rates of their own.
struct DegradingParts {
  std::span<const std::uint8_t> on_protrusion; ///< 1 for the segments that belong to any protrusion
  std::span<const std::uint8_t> of_front{};    ///< 1 for the particles of the front; empty: all of them
  std::span<const LawPlace> places{};          ///< of each particle of the cortex, for laws that use them
};

/// Degrades for dt, after positions have moved by dt v: around the tips, along protrusions and around the body by their
/// laws, each within its reach, around the rear of the body rear_share times that (a segment is of the front if its
/// first particle is); the faster one counts. Particles that reach f = 0 become fluid.
/// @param tips  positions of the pushing particles of all growing protrusions in the middle of the step [um]
void degrade(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby, const DegradingParts& parts,
             std::span<const Vec2> tips, double dt, const Laws& laws);

/// Fluidizes solid particles deeper inside the cell than contact.deepest_solid.   @return how many
std::size_t fluidize_engulfed(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby);

} // namespace matrigrate
