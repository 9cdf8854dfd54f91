#pragma once

#include "parameters/laws/law.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "sph/interpolate.hpp"
#include "state/cell.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Adhesion of a protrusion's tip to a point of the continuum (Heck et al. 2020, sections "Adhesion" and "Protrusion
/// retraction"; MODEL.md, I18). Test: tests/unit/protrusion/adhesion_test.cpp
namespace matrigrate {

/// Force of an adhesion spring, tension only: k max(0, L - l_0,adh), k by laws.adhesion_stiffness, k_ad by default
/// [nN].
/// @param length  L [um]
double adhesion_force(double length, const AdhesionParameters& p, const Laws& laws, const LawPlace& place = {});

/// 2 f_mat F_am, which Eqs. (7) and (9) take: the full pull of both strands (MODEL.md, I28) [nN].
double mature_pull(double f_mat, const Parameters& p);

/// Whether the force breaks the adhesion, second case of Eq. (7): F >= f_rupt mature_pull(), where ruptures are on.
bool ruptures(double F, double f_mat, const Parameters& p);

/// The anchor of a phase, or null.
const Vec2* anchor(const Phase& phase);
Vec2* anchor(Phase& phase);

/// How a point of the solid that an adhesion is to hold, or a phase's adhesion, hangs in the solid: with the kernel of
/// adhesions, around the point as it is now, or around where it was in the reference configuration (MODEL.md, I18).
/// Empty for a phase without adhesion.
PointWeights hold_weights(const Vec2& point, const EcmState& ecm, const Parameters& p);
PointWeights hold_weights(const Phase& phase, const EcmState& ecm, const Parameters& p);

/// Where a point of the solid was in the reference configuration [um].
/// @param weights  of the point, from hold_weights()
Vec2 reference_position(const Vec2& point, const PointWeights& weights, const EcmState& ecm);

/// Force of the adhesion of a protrusion now; 0 without one [nN].
double adhesion_force(const CortexState& c, const Protrusion& protrusion, const AdhesionParameters& p, const Laws& laws,
                      const LawPlace& place = {});

/// How fast that force grows with the length of the adhesion: its stiffness, or the slope where it stiffens [nN/um].
double adhesion_slope(double length, const AdhesionParameters& p, const Laws& laws, const LawPlace& place = {});

/// Speed at which the adhesion of a protrusion lengthened in the last step; 0 without one [um/s].
/// @param weights  of its anchor
double lengthening(const CortexState& c, const Protrusion& protrusion, const EcmState& ecm,
                   const PointWeights& weights);

/// How the anchor of each protrusion of a cell hangs in the solid; empty for those without.
std::vector<PointWeights> anchor_weights(const Cell& cell, const EcmState& ecm, const Parameters& p);

/// Adds the adhesion forces on centre particles, and their reactions on the solid; linearly implicit. An adhesion that
/// has just formed, or that would be taut after dt if it went on as in the last step, counts as taut: as if slack, it
/// would be stretched by all that the tip moves in the step.
/// @param places  of each particle of the cortex, for laws that use them   @param weights  from anchor_weights()
/// @param first   node of particle 0 of the cortex   @param force  of all nodes, but for those of the matrix [nN]
/// @param on_matrix  forces on the nodes of the matrix
void add_adhesions(const Cell& cell, const EcmState& ecm, const AdhesionParameters& p, const Laws& laws,
                   std::span<const LawPlace> places, std::span<const PointWeights> weights, double dt,
                   std::uint32_t first, std::span<Vec2> force, NodeForces& on_matrix, DragSystem& A);

/// The solid carries the anchors along for dt.   @param v  velocities of its particles, and perhaps others [um/s]
void move_anchors(Cell& cell, std::span<const Vec2> v, std::span<const PointWeights> weights, double dt);

} // namespace matrigrate
