#pragma once

#include "base/vector.hpp"
#include "ecm/reference.hpp"
#include "state/ecm.hpp"

#include <vector>

namespace matrigrate {

/// Deformation gradient over reference neighbours (MODEL.md, D4; exact for every linear displacement):
///   F_i = I + (sum_j V_0 f_j (u_j - u_i) (x) grad_0 W_ij) B_i        [-]
/// Test: tests/unit/ecm/deformation_test.cpp
Mat2 deformation_gradient(const EcmState& ecm, const Reference& ref, std::size_t i);

/// Its rate, from the velocities of `ecm` [1/s].
Mat2 deformation_rate(const EcmState& ecm, const Reference& ref, std::size_t i);

/// The same sums for all solid particles and any field a; 0 for fluid ones. Displacements give F - I, velocities dF/dt.
void gradients(const EcmState& ecm, const Reference& ref, const VectorPlanes& a, std::vector<Mat2>& gradient);

} // namespace matrigrate
