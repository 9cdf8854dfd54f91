#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <array>
#include <span>

/// Weak bending resistance of the cortex, Heck et al. 2020, Eq. (1), term F^b (MODEL.md, I11).
/// Test: tests/unit/cell/cell_test.cpp
namespace matrigrate {

/// Angle by which the ring turns to the left at particle i [rad].
double turning_angle(const CortexState& c, std::size_t i);

/// Its derivatives with respect to the positions of the previous particle, i, and the next one [rad/um].
std::array<Vec2, 3> turning_angle_gradient(const CortexState& c, std::size_t i);

/// Sum of k_bend (theta - theta_0)^2 / 2 with theta_0 = 2 pi/n, the angle of the round cell [nN um].
double bending_energy(const CortexState& c, const CellParameters& p);

/// Adds its negative gradient to the forces, linearly implicit (Gauss-Newton: dt k_bend g g^T).
/// @param first  node of particle 0   @param force  of all nodes [nN]
void add_bending(const CortexState& c, const CellParameters& p, double dt, std::uint32_t first, std::span<Vec2> force,
                 DragSystem& A);

} // namespace matrigrate
