#pragma once

#include "contact/proximity.hpp"
#include "parameters/laws/laws.hpp"
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

/// Rate at which an encounter degrades its particle [1/s]: the protrusion's or the body's, where the particle is closer
/// than its reach and degradation_pressure() is above p_th, else 0.
/// @param on_protrusion  whether the closest segment belongs to a protrusion
/// @param solid_pressure [kPa]   @param stiffness  of the particle, E_k/E, which scales the contact pressure [-]
/// @param f  intact fraction of the particle, for laws that a user has changed [-]
double degradation_rate(double distance, bool on_protrusion, double solid_pressure, const Parameters& p,
                        double stiffness = 1.0, double f = 1.0, const Laws& laws = usual_laws());

/// Parts of the cortex that degrade at rates of their own.
struct DegradingParts {
  std::span<const std::uint8_t> on_protrusion; ///< 1 for the segments that belong to any protrusion
  std::span<const std::uint8_t> of_front{};    ///< 1 for the particles of the front; empty: all of them
};

/// Degrades for dt, after positions have moved by dt v: around the tips at tip_rate whatever the pressure, along
/// protrusions and body by degradation_rate(), around the rear of the body rear_share times that (a segment is of the
/// front if its first particle is); the faster one counts. Particles that reach f = 0 become fluid.
/// @param tips  positions of the pushing particles of all growing protrusions in the middle of the step [um]
void degrade(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby, const DegradingParts& parts,
             std::span<const Vec2> tips, double dt, const Laws& laws = usual_laws());

/// Fluidizes solid particles deeper inside the cell than contact.deepest_solid.   @return how many
std::size_t fluidize_engulfed(EcmState& ecm, const Parameters& p, std::span<const NearbyParticle> nearby);

} // namespace matrigrate
