#include "ecm/viscosity.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace matrigrate {

namespace {

/// Squared distances of pairs become their G_ij.
MATRIGRATE_SIMD
void become_drags(std::span<double> r2, const Kernel& kernel, double V, const EcmParameters& p) {
  for (double& G : r2) G = pair_drag(G, kernel.W_slope(std::sqrt(G)), V, p.viscosity, p.thickness, kernel.h());
}

/// Row i from its G_ij: diagonal and right-hand side. Drag of clamped particles becomes a force; clamped particles ask
/// for their given velocity.
void finish_row(const EcmState& ecm, const Adjacency& pairs, std::size_t i, DragSystem& A) {
  double* G = A.coupling.data() + pairs.first[i];
  if (ecm.clamped[i]) {
    A.diagonal[i] = 1.0;
    A.F[i] = ecm.v[i];
    std::fill_n(G, pairs.of(i).size(), 0.0);
    return;
  }
  double sum = 0.0;
  Vec2 F = Vec2::Zero();
  for (const std::uint32_t j : pairs.of(i)) {
    sum += *G;
    if (ecm.clamped[j]) {
      F += *G * ecm.v[j];
      *G = 0.0;
    }
    ++G;
  }
  A.diagonal[i] = sum > 0.0 ? sum : 1.0; // a particle without partners feels no force and stays
  A.F[i] = F;
}

} // namespace

void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const Adjacency& pairs, DragSystem& A) {
  constexpr std::size_t block = 64; // particles whose entries are computed in one go
  const Kernel kernel(p.smoothing_length);
  A.pairs = &pairs;
  A.coupling.resize(pairs.pairs());
  A.diagonal.resize(ecm.size());
  A.F.resize(ecm.size());
  A.position = ecm.x;
  // Either entry of a pair is computed on its own, to the same bits: squares do not know the sign of a distance.
  const auto of_block = [&](std::size_t b) {
    const std::size_t end = std::min(ecm.size(), (b + 1) * block);
    double* r2 = A.coupling.data() + pairs.first[b * block]; // squared distances first, drags in their place
    for (std::size_t i = b * block; i < end; ++i)
      for (const std::uint32_t j : pairs.of(i)) *r2++ = ecm.separation(i, j).squaredNorm();
    const std::size_t count = pairs.first[end] - pairs.first[b * block];
    become_drags({r2 - count, count}, kernel, ecm.V0, p);
    for (std::size_t i = b * block; i < end; ++i) finish_row(ecm, pairs, i, A);
  };
  parallel_for((ecm.size() + block - 1) / block, of_block, 8);
}

} // namespace matrigrate
