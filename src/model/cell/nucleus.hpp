#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// The nucleus of a cell: a ring like the cortex, the lamina, filled with chromatin (MODEL.md, I40). Not part of Heck
/// et al. 2020. What joins it to the cortex is in contact/nucleus.hpp. Test: tests/unit/cell/nucleus_test.cpp
namespace matrigrate {

/// Whether cells have a nucleus.
inline bool has_nucleus(const Parameters& p) { return p.nucleus.radius > 0.0; }

/// The lamina as a ring of cell/spring, cell/bending and cell/area: their parameters for segments of length l_0, so
/// that the ring's stiffness does not depend on its number of particles:
///   k_s = Y/l_0, dashpot tau Y/l_0, k_bend = B/l_0, k_A = K t_z l_0/A_0,
/// with Y = nucleus.stretch_stiffness, tau = retardation_time, B = bending_stiffness, K = bulk_modulus.
CellParameters lamina(const Parameters& p);

/// The round nucleus of the start around the centre of its cell, at rest; empty without nucleus.
CortexState round_nucleus(const Parameters& p, const CellStart& start);

/// Stiffness of a spring of the chromatin, which joins particle i to particle i + m/2 of m: 4 pi G t_z/m [nN/um]. An
/// elastic disc of shear modulus G = nucleus.shear_modulus that is drawn to an ellipse by a small strain stores the
/// energy of the springs (a sum of m/2 springs along diameters).
double chromatin_stiffness(const NucleusParameters& n, double thickness);

/// Energy of lamina and chromatin: stretch, crowding, bending, lost area, shear [nN um].
double nucleus_energy(const CortexState& nucleus, const Parameters& p);

/// Adds its negative gradient to the forces, and the dashpots of all springs; linearly implicit.
/// @param first  node of particle 0 of the nucleus   @param force  of all nodes [nN]
void add_nucleus(const CortexState& nucleus, const Parameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A);

/// Longest over shortest axis of the area inside a ring, by its second moments: 1 for a circle [-].
double aspect_ratio(const CortexState& ring);

} // namespace matrigrate
