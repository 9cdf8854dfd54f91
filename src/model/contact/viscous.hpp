#pragma once

#include "contact/proximity.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"

#include <cstdint>
#include <span>

/// Viscous coupling of cell and matrix, Heck et al. 2020, Eqs. (1) and (2), Gamma_ik (MODEL.md, I12).
/// Test: tests/unit/contact/contact_test.cpp
namespace matrigrate {

/// Adds the drag between the cortex and the matrix: a segment of current length l carries the volume l dp, sampled at
/// points no further apart than contact.sample_spacing; each point meets particle k by pair_drag() (ecm) with their
/// volumes, times f_degr,k and, on the outer side of the segment, a share of the rest: contact.fluid_share where the
/// segment is soft, else contact.body_fluid_share. Obstacles do not move: their drag is that of a wall.
/// @param soft   1 for the segments of growing and maturing protrusions
/// @param first  node of particle 0 of the cortex
void add_viscous_contact(const EcmState& ecm, const CortexState& c, std::span<const std::uint8_t> soft,
                         const Parameters& p, const SegmentGrid& grid, std::uint32_t first, DragSystem& A);

} // namespace matrigrate
