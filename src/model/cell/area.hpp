#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <span>

/// Weak conservation of the cell's area, Heck et al. 2020, Eq. (1), term F^A (MODEL.md, I11).
/// Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// k_A (A_0 - A)^2 / (2 l_0) while A < A_0, else 0 [nN um]: a pressure that gives each particle of the unstretched ring
/// the paper's k_A (A_0 - A) along the normal, and sums to no net force on any shape.
double area_energy(const CortexState& c, const CellParameters& p);

/// Adds its negative gradient to the forces, linearly implicit.
/// @param first  node of particle 0   @param force  of all nodes [nN]
void add_area(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
              DragSystem& A);

} // namespace matrigrate
