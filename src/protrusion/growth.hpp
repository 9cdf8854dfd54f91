#pragma once

#include "parameters/parameters.hpp"
#include "state/state.hpp"

#include <span>
#include <vector>

/// Growth of a protrusion (Heck et al. 2020, section "Protrusion growth"; MODEL.md, D16).
/// Test: tests/unit/protrusion/growth_test.cpp
namespace matrigrate {

/// The particles that push: the centre and tip_half_width to either side.
std::vector<std::size_t> pushing_particles(const CortexState& c, std::size_t centre, const ProtrusionParameters& p);

/// Force of one pushing particle: F_prot over their number, along d_prot, reduced as the normal turns away:
/// max(0, n . d_prot) [nN].
/// @param direction  d_prot, unit vector   @param normal  outward unit normal of the particle
Vec2 growth_force(const Vec2& direction, const Vec2& normal, const ProtrusionParameters& p);

/// Share of the growth force that is left as the cell's area nears its limit, Heck et al. 2020, Eq. (10): 1 up to A_0,
/// then falling linearly to 0 at area_limit A_0. Without a kept number always 1 [-].
/// @param area  of the cell over A_0 [-]
double area_factor(double area, const ProtrusionParameters& p);

/// Adds the growth forces of all growing protrusions.
/// @param area     of the cell over A_0 [-]
/// @param normals  outward unit normals of the cortex particles
/// @param force    of all nodes [nN]
void add_growth(const State& s, const ProtrusionParameters& p, double area, std::span<const Vec2> normals,
                std::span<Vec2> force);

/// Lets the particles on either flank of growing protrusions slide along the contour towards equal spacing for dt, so
/// that the stretch does not gather at the tip. The centre stays at the tip, the first and last particle at the base.
void spread_evenly(State& s, const ProtrusionParameters& p, double dt);

/// l_prot: distance from the middle between the first and the last particle to the centre [um].
double protrusion_length(const CortexState& c, std::size_t centre, const ProtrusionParameters& p);

/// The rest lengths of the segments between the first and the last particle become their lengths.
void relax_rest_lengths(CortexState& c, std::size_t centre, const ProtrusionParameters& p);

} // namespace matrigrate
