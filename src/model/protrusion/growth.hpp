#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Growth of a protrusion (Heck et al. 2020, section "Protrusion growth"; MODEL.md, I16).
/// Test: tests/unit/protrusion/protrusion_test.cpp
namespace matrigrate {

/// The particles that push: the centre and tip_half_width to either side.
std::vector<std::size_t> pushing_particles(const CortexState& c, std::size_t centre, const ProtrusionParameters& p);

/// Force of one pushing particle: F_prot over their number, along d_prot, reduced as the normal turns away:
/// max(0, n . d_prot) [nN].
/// @param direction  d_prot, unit vector   @param normal  outward unit normal of the particle
Vec2 growth_force(const Vec2& direction, const Vec2& normal, const ProtrusionParameters& p);

/// Adds the growth forces of all growing protrusions.
/// Linearly implicit in the speed of the tip, where the law depends on it.
/// @param area     of the cell over A_0 [-]
/// @param normals  outward unit normals of the cortex particles
/// @param force    of all nodes [nN]
/// @param t        now [s]
/// @param law      laws.growth_force, Eq. (10)
/// @param places   of each particle of the cortex, if the law uses them
void add_growth(const Cell& cell, const ProtrusionParameters& p, double area, std::span<const Vec2> normals,
                std::uint32_t first, std::span<Vec2> force, DragSystem& A, double t, const Law& law,
                std::span<const LawPlace> places = {});

/// Lets the particles on either flank of growing protrusions slide along the contour towards equal spacing for dt, so
/// that the stretch does not gather at the tip. The centre stays at the tip, the first and last particle at the base.
void spread_evenly(Cell& cell, const ProtrusionParameters& p, double dt);

/// l_prot: distance from the middle between the first and the last particle to the centre [um].
double protrusion_length(const CortexState& c, std::size_t centre, const ProtrusionParameters& p);

/// Distance between the first and the last particle of a protrusion [um].
double base_width(const CortexState& c, std::size_t centre, const ProtrusionParameters& p);

/// The tie between both ends of each growing protrusion: the cortex that was there
/// stays behind as an arc, so that the ring is not open at the base. Tension only, stiffness k_s over the number of
/// segments, rest length the width at initiation; linearly implicit.
/// @param k_s  stiffness of a segment [nN/um]   @param force  of all nodes [nN]
void add_base_ties(const Cell& cell, const ProtrusionParameters& p, double k_s, double dt, std::uint32_t first,
                   std::span<Vec2> force, DragSystem& A);

/// The rest lengths of the segments between the first and the last particle become their lengths.
void relax_rest_lengths(CortexState& c, std::size_t centre, const ProtrusionParameters& p);

} // namespace matrigrate
