#pragma once

#include "base/adjacency.hpp"
#include "parameters/parameters.hpp"
#include "sph/kernel.hpp"
#include "state/ecm.hpp"

#include <span>
#include <vector>

/// Pressure of degraded matrix (MODEL.md, I6). Test: tests/unit/ecm/loop/loop_test.cpp
namespace matrigrate {

/// Sum of V_0 W over an intact lattice, the particle itself included [-].
double lattice_density(const EcmParameters& p);

/// Pressure of particle i as fluid, (1 - f_i) K_i max(0, rho_sum / rho_lattice - 1) [kPa]. rho_sum is the summed
/// density V_0 sum_j W_ij over all particles, i included, at current positions; K_i is proportional to E_i.
double fluid_pressure(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, const Kernel& kernel,
                      double rho_lattice, std::size_t i);

/// Sets the pressures of the particles with f < 1 [kPa].
void find_fluid_pressures(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                          std::vector<double>& pressure);

/// Adds -t_z V_0^2 sum_j (p_i + p_j) grad_i W_ij to the forces [nN].
/// @param pressure  of find_fluid_pressures() [kPa]
void add_fluid_forces(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs,
                      std::span<const double> pressure, std::span<Vec2> force);

} // namespace matrigrate
