#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <span>

/// Repulsion of the cortex from itself, Heck et al. 2020, Eq. (1), term F^rep: a particle closer than d_rep to a
/// segment whose ends are at least three particles away along the ring. Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// k_rep (d_rep - d)^1.5 for d < d_rep, Hertz-like; closer than d_w = d_rep/2 also k_rep d_w^1.5 (d_w/d - 1), which has
/// no bound (MODEL.md, I31) [nN].   @param d  distance [um], > 0
double repulsion(double d, const CellParameters& p);

/// Sum over touching particles of the work against repulsion() [nN um].
double repulsion_energy(const CortexState& c, const CellParameters& p);

/// Adds the repulsion, shared by the ends of the segment, linearly implicit along the distance.
/// @param first  node of particle 0   @param force  of all nodes [nN]
void add_repulsion(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                   DragSystem& A);

} // namespace matrigrate
