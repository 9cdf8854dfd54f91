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

/// The same for the particles of a row, t of them, and any field a: displacements give F - I, velocities dF/dt.
/// @param fa   f_j a_j of all particles
/// @param own  own(i) is a_i
/// @param use  use(i, gradient) for each particle; 0 for fluid ones
template <class Own, class Use>
void row_gradients(const EcmState& ecm, const Reference& ref, const RowTerms& terms, const VectorPlanes& fa,
                   const Own& own, const Use& use) {
  RowTensors sum;
  sum_gradient(terms, fa, sum);
  const double lattice = ecm.V0 * ref.lattice_correction();
  for (std::size_t t = 0; t < terms.row.count; ++t) {
    const std::size_t i = terms.row.begin + t;
    if (ref.whole(i) && ecm.f[i] == 1.0) {
      use(i, Mat2(lattice * sum[t]));
      continue;
    }
    const Mat2 gradient = sum[t] - own(i) * ref.moments(i).grad_W.transpose();
    use(i, ecm.f[i] > 0.0 ? Mat2(ecm.V0 * gradient * ref.B(i)) : Mat2(Mat2::Zero()));
  }
}

} // namespace matrigrate
