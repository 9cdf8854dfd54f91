#include "ecm/viscosity.hpp"

#include "base/parallel.hpp"

#include <cmath>

namespace matrigrate {

namespace {

/// Row of a particle whose velocity is given.
void set_given(DragSystem& A, std::size_t i, const Vec2& v) {
  A.diagonal[i] = 1.0;
  A.F[i] = v;
  for (std::uint32_t k = A.pairs->first[i]; k < A.pairs->first[i + 1]; ++k) A.coupling[k] = 0.0;
}

} // namespace

void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, DragSystem& A) {
  const Kernel kernel(p.smoothing_length);
  A.pairs = &pairs;
  A.coupling.resize(pairs.pairs());
  A.diagonal.resize(ecm.size());
  A.F.resize(ecm.size());
  A.position = ecm.x;
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.clamped[i]) return set_given(A, i, ecm.v[i]);
    double sum = 0.0;
    Vec2 F = Vec2::Zero();
    for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
      const std::uint32_t j = pairs.index[k];
      const double r2 = ecm.separation(i, j).squaredNorm();
      const double G_ij = pair_drag(r2, kernel.W_slope(std::sqrt(r2)), ecm.V0, p.viscosity, p.thickness, kernel.h());
      sum += G_ij;
      A.coupling[k] = ecm.clamped[j] ? 0.0 : G_ij;
      if (ecm.clamped[j]) F += G_ij * ecm.v[j];
    }
    A.diagonal[i] = sum > 0.0 ? sum : 1.0; // a particle without partners feels no force and stays
    A.F[i] = F;
  });
}

} // namespace matrigrate
