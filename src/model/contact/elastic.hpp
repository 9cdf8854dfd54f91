#pragma once

#include "contact/proximity.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"

#include <cstdint>
#include <span>

/// Elastic contact of cell and solid matrix, Heck et al. 2020, Eq. (1), term F^sigma (MODEL.md, I13).
/// Test: tests/unit/contact/contact_test.cpp
namespace matrigrate {

/// Contact pressure K (1 - d/d_c) for d < d_c, else 0 [kPa].   @param distance  outside positive [um]
double contact_pressure(double distance, const Parameters& p);

/// How many times as stiff as uniform matrix an obstacle resists the cell. A single particle then bears F_prot when the
/// tip is 1.2 % of contact.range nearer than where contact begins (200 Pa; 5 % at 50 Pa; MODEL.md, I33).
inline constexpr double obstacle_contact = 20.0;

/// Adds f_degr (E_k/E) p_c dp t_z along the normal to the particle and its reaction to the ends of the segment,
/// linearly implicit along the normal. For a particle of an obstacle, which does not move, obstacle_contact stands in
/// place of f_degr E_k/E.
/// @param first      node of particle 0 of the cortex   @param force  of all nodes, but for those of the matrix [nN]
/// @param on_matrix  forces on the nodes of the matrix
void add_elastic_contact(const EcmState& ecm, const CortexState& c, const Parameters& p,
                         std::span<const NearbyParticle> nearby, double dt, std::uint32_t first, std::span<Vec2> force,
                         NodeForces& on_matrix, DragSystem& A);

} // namespace matrigrate
