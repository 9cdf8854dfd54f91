#pragma once

#include "base/vector.hpp"
#include "ecm/reference.hpp"
#include "state/ecm.hpp"

#include <vector>

namespace matrigrate {

/// Deformation gradient over reference neighbours (MODEL.md, I4; exact for every linear displacement):
///   F_i = I + (sum_j V_0 f_j (u_j - u_i) (x) grad_0 W_ij) B_i        [-]
/// Test: tests/unit/ecm/loop/loop_test.cpp
Mat2 deformation_gradient(const EcmState& ecm, const Reference& ref, std::size_t i);

/// Its rate, from the velocities of `ecm` [1/s].
Mat2 deformation_rate(const EcmState& ecm, const Reference& ref, std::size_t i);

/// The same for the particles of a row and any vector field a: displacements give F - I, velocities give dF/dt. 0 in
/// the fluid.
/// @param fa   f_j a_j of all particles
/// @param own  own(i) is a_i
template <class Own>
void row_gradients(const EcmState& ecm, const Reference& ref, const RowTerms& terms, const VectorPlanes& fa,
                   const Own& own, RowTensors& gradient) {
  sum_gradient(terms, fa, gradient);
  const double lattice = ecm.V0 * ref.lattice_correction();
  ref.each_stretch(ecm, terms.row, [&](std::size_t begin, std::size_t end, bool plain) {
    if (plain) return;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t t = i - terms.row.begin;
      if (ecm.f[i] <= 0.0) {
        gradient.set(t, Mat2::Zero());
        continue;
      }
      const Mat2 sum = gradient[t] - own(i) * ref.moments(i).grad_W.transpose();
      gradient.set(t, ecm.V0 / lattice * sum * ref.B(i));
    }
  });
  scale(lattice, terms.row.count, gradient);
}

} // namespace matrigrate
