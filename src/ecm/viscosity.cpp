#include "ecm/viscosity.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace matrigrate {

namespace {

/// Row of a particle whose velocity is given.
void set_given(DragSystem& A, std::size_t i, const Vec2& v) {
  A.diagonal[i] = 1.0;
  A.F[i] = v;
  for (std::uint32_t k = A.pairs->first[i]; k < A.pairs->first[i + 1]; ++k) A.coupling[k] = 0.0;
}

/// G_ij of pairs at the squared distances r2.
MATRIGRATE_SIMD
void pair_drags(std::span<const double> r2, const Kernel& kernel, double V, const EcmParameters& p,
                std::span<double> G) {
  for (std::size_t m = 0; m < r2.size(); ++m)
    G[m] = pair_drag(r2[m], kernel.W_slope(std::sqrt(r2[m])), V, p.viscosity, p.thickness, kernel.h());
}

/// Fills the coupling of all pairs; each is computed once.
void couple_pairs(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, std::vector<double>& coupling) {
  constexpr std::size_t block = 64; // particles whose pairs are computed in one go
  const Kernel kernel(p.smoothing_length);
  const auto of_block = [&](std::size_t b) {
    const std::size_t end = std::min(ecm.size(), (b + 1) * block);
    std::vector<std::uint32_t> entry(pairs.first[end] - pairs.first[b * block]);
    std::vector<double> r2(entry.size());
    std::size_t count = 0;
    for (std::size_t i = b * block; i < end; ++i)
      for (std::uint32_t k = pairs.upper(i); k < pairs.first[i + 1]; ++k, ++count) {
        entry[count] = k;
        r2[count] = ecm.separation(i, pairs.index[k]).squaredNorm();
      }
    entry.resize(count);
    r2.resize(count);
    std::vector<double> G(r2.size());
    pair_drags(r2, kernel, ecm.V0, p, G);
    for (std::size_t m = 0; m < entry.size(); ++m) {
      coupling[entry[m]] = G[m];
      coupling[pairs.mirror[entry[m]]] = G[m];
    }
  };
  parallel_for((ecm.size() + block - 1) / block, of_block, 8);
}

} // namespace

void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, DragSystem& A) {
  A.pairs = &pairs;
  A.coupling.resize(pairs.pairs());
  A.diagonal.resize(ecm.size());
  A.F.resize(ecm.size());
  A.position = ecm.x;
  couple_pairs(ecm, p, pairs, A.coupling);
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
