#pragma once

#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "sph/kernel.hpp"
#include "state/ecm.hpp"

namespace matrigrate {

/// Drag between two particles, viscous term of Heck et al. 2020, Eq. (2):
///   G_ij = t_z V_i V_j (mu_i + mu_j) (-x_ij . grad_i W_ij) / (|x_ij|^2 + 0.01 h^2) >= 0
/// The force on i is -G_ij (v_i - v_j): the weakly Laplacian form mu lap(v) of Morris et al. 1997. It acts along the
/// velocity difference, so it conserves linear momentum exactly and resists a rotation of a finite body.
/// @param r2       |x_ij|^2 [um^2]   @param W_slope  kernel.W_slope(|x_ij|) [1/um^4], <= 0
/// @param V        volume of either particle per depth [um^2]   @param mu  viscosity [nN s/um^2]   @param t_z  depth
/// [um]
/// @return         [nN s/um]
/// Test: tests/unit/ecm/viscosity_test.cpp
inline double pair_drag(double r2, double W_slope, double V, double mu, double t_z, double h) {
  return t_z * V * V * 2.0 * mu * (-W_slope) * r2 / (r2 + 0.01 * h * h);
}

/// Fills A with the drag of all pairs at the current positions, in single precision, and A.F with the drag of the
/// clamped particles on the free ones; forces are added to A.F afterwards. Rows of clamped particles ask for their
/// given velocity, those of particles without partners for none.
/// @param pattern  of a list that is valid for the positions of `ecm`, with its clamped particles
/// @param share    of the drag that resists changes of the velocities of `ecm`, beside the drag itself; theta >= 0
void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const RowPattern& pattern, DragSystem& A,
                        double share = 0.0);

} // namespace matrigrate
