#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <cstdint>
#include <span>

/// Initiation of protrusions (Heck et al. 2020, section "Protrusion initiation"). Test:
/// tests/unit/protrusion/initiation_test.cpp
namespace matrigrate {

/// Whether a protrusion could be centred on particle i: none of its particles belongs to one.
/// @param of_particle  from membership()
bool has_room(const CortexState& c, std::size_t i, std::span<const int> of_particle, const ProtrusionParameters& p);

/// Each particle of the front that has room initiates a protrusion with probability 1 - exp(-r_prot dt), in the order
/// of the ring; it grows from the centre of mass towards the particle. The first of all sets the polarization.
///
/// With a kept number (protrusion.number > 0) instead one candidate a step is drawn among all particles, rear ones
/// rear_share times as likely; it initiates if it has room, fewer than that number live, and the cell's area is no more
/// than area_limit A_0 (Heck et al. 2020, section on the number of protrusions; MODEL.md, D27).
/// @param of_front  1 for the particles of the front; all of them before the first protrusion
/// @param centre    centre of mass of the cell [um]
/// @param area      of the cell over A_0; matters with a kept number [-]
void initiate(State& s, const Parameters& p, std::span<const std::uint8_t> of_front, const Vec2& centre,
              double area = 1.0);

} // namespace matrigrate
