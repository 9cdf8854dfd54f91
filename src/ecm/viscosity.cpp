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
  const double support2 = kernel.support() * kernel.support();
  A.pairs = &pairs;
  A.coupling.resize(pairs.pairs());
  A.diagonal.resize(ecm.size());
  A.F.resize(ecm.size());
  A.position = ecm.x;
  parallel_for(ecm.size(), [&](std::size_t i) { // each pair once
    for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
      const std::uint32_t j = pairs.index[k];
      if (j < i) continue;
      const double r2 = ecm.separation(i, j).squaredNorm();
      const double G_ij =
          r2 < support2 ? pair_drag(r2, kernel.W_slope(std::sqrt(r2)), ecm.V0, p.viscosity, p.thickness, kernel.h())
                        : 0.0;
      A.coupling[k] = G_ij;
      A.coupling[pairs.mirror[k]] = G_ij;
    }
  });
  parallel_for(ecm.size(), [&](std::size_t i) {
    if (ecm.clamped[i]) return set_given(A, i, ecm.v[i]);
    double sum = 0.0;
    Vec2 F = Vec2::Zero();
    for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
      const std::uint32_t j = pairs.index[k];
      sum += A.coupling[k];
      if (!ecm.clamped[j]) continue;
      F += A.coupling[k] * ecm.v[j];
      A.coupling[k] = 0.0;
    }
    A.diagonal[i] = sum > 0.0 ? sum : 1.0; // a particle without partners feels no force and stays
    A.F[i] = F;
  });
}

} // namespace matrigrate
