#pragma once

#include "base/adjacency.hpp"
#include "ecm/loop/stress.hpp"
#include "parameters/parameters.hpp"
#include "state/ecm.hpp"

#include <span>

/// Stress of the solid over current neighbours (updated-Lagrangian SPH), as in most of the SPH literature (Gray et al.
/// 2001). For comparison only: under a pulling load the gel tears numerically (`validate tearing`). Test:
/// tests/unit/ecm/loop/updated_lagrangian_test.cpp
namespace matrigrate {

/// Adds t_z sum_j V_i V_j (f_i sigma_i + f_j sigma_j) grad_i W_ij, V = V_0/rho, to the forces [nN].
void add_current_elastic_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                                std::span<Vec2> force);

/// Velocity gradient L_i = sum_j V_j (v_j - v_i) (x) grad_i W_ij over current neighbours [1/s].
Mat2 current_velocity_gradient(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, std::size_t i);

/// Advances density and deviatoric stress by dt with L over current neighbours (explicit Euler).
DensityBounds advance_current_stress(EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, double dt);

} // namespace matrigrate
