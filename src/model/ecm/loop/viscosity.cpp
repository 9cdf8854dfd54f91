#include "ecm/loop/viscosity.hpp"

#include "base/pack.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace matrigrate {

namespace {

constexpr double nowhere = 1e9; // where the particles beyond the last are, out of reach of all others [um]

/// |x_ij|^2 of the eight particles from row on and their partners at a distance.
[[gnu::always_inline]] inline void squared_distances(const double* x_i, const double* y_i, std::ptrdiff_t distance,
                                                     double period_x, float* r2) {
  if (period_x > 0.0) {
    for (std::size_t l = 0; l < RowBlocks::lanes; ++l) {
      const Vec2 x_ij(x_i[l] - x_i[static_cast<std::ptrdiff_t>(l) + distance],
                      y_i[l] - y_i[static_cast<std::ptrdiff_t>(l) + distance]);
      r2[l] = static_cast<float>(nearest_image(x_ij, period_x).squaredNorm());
    }
    return;
  }
  for (std::size_t l = 0; l < RowBlocks::lanes; l += pack_size<Doubles>) {
    Doubles x, y, x_j, y_j;
    load(x_i + l, x);
    load(y_i + l, y);
    load(x_i + distance + l, x_j);
    load(y_i + distance + l, y_j);
    x -= x_j;
    y -= y_j;
    store_pack(__builtin_convertvector(x * x + y * y, HalfFloats), r2 + l);
  }
}

/// G_ij of the eight particles from row on and their partners at the distances, 0 for those out of reach; distances
/// without any within reach are left out. Adds the sums over partners to D.
/// @return the number of distances that remain
MATRIGRATE_SIMD
std::size_t pair_drags(const DoubleField& x, std::size_t row, double period_x, const PairDrag<float>& law,
                       std::span<std::int32_t> distances, float* G, double* D) {
  for (std::size_t k = 0; k < distances.size(); ++k)
    squared_distances(x.x() + row, x.y() + row, distances[k], period_x, G + RowBlocks::lanes * k);
  const PairDrag<float> drag = law; // which no store to G can change
  for (std::size_t k = 0; k < RowBlocks::lanes * distances.size(); ++k) {
    const float r2 = G[k];
    G[k] = drag(std::sqrt(r2), r2);
  }
  Doubles low{}, high{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    HalfFloats g_low, g_high;
    load(G + RowBlocks::lanes * k, g_low);
    load(G + RowBlocks::lanes * k + 4, g_high);
    store_pack(g_low, G + RowBlocks::lanes * count);
    store_pack(g_high, G + RowBlocks::lanes * count + 4);
    Doubles wide_low, wide_high;
    widen(g_low, wide_low);
    widen(g_high, wide_high);
    low += wide_low;
    high += wide_high;
    distances[count] = distances[k];
    if (any(g_low) || any(g_high)) ++count;
  }
  store_pack(low, D);
  store_pack(high, D + 4);
  return count;
}

/// Takes clamped particles out of the coefficients of a block, as pair_drags.   @param free  1, or 0 for clamped ones
MATRIGRATE_SIMD
std::size_t leave_out_clamps(const Field& free, std::size_t row, std::span<std::int32_t> distances, float* G) {
  Floats of_i;
  load(free.x() + row, of_i);
  std::size_t count = 0;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    Floats g, of_j;
    load(G + RowBlocks::lanes * k, g);
    load(free.x() + row + distances[k], of_j);
    g *= of_i * of_j;
    store_pack(g, G + RowBlocks::lanes * count);
    distances[count] = distances[k];
    if (any(g)) ++count;
  }
  return count;
}

/// Makes F the velocities of the clamped particles, and zero for the others.   @return whether any of them moves
bool prescribe_clamps(const EcmState& ecm, std::vector<Vec2>& F) {
  F.assign(ecm.size(), Vec2::Zero());
  bool move = false;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (!ecm.clamped[i]) continue;
    F[i] = ecm.v[i];
    move = move || ecm.v[i] != Vec2(0.0, 0.0);
  }
  return move;
}

/// Adds the drag of clamped particles on the others to their forces.
void add_drag_of_clamps(const EcmState& ecm, std::size_t row, std::span<const std::int32_t> distances, const float* G,
                        std::span<Vec2> F) {
  for (std::size_t k = 0; k < distances.size(); ++k)
    for (std::size_t l = 0; l < RowBlocks::lanes; ++l) {
      if (G[RowBlocks::lanes * k + l] == 0.0F) continue;
      const std::size_t i = row + l;
      const std::size_t j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + distances[k]);
      if (ecm.clamped[j] && !ecm.clamped[i]) F[i] += static_cast<double>(G[RowBlocks::lanes * k + l]) * ecm.v[j];
    }
}

} // namespace

/// Marks the blocks of all particles that are not where they were, and of their neighbours; of others now and then.
void ViscosityRows::mark_moved(std::span<const Vec2> x, const Adjacency& pairs, const RowPattern& pattern) {
  const bool all = m_stale.size() != pattern.blocks();
  m_stale.assign(pattern.blocks(), all ? 1 : 0);
  if (m_x_seen.size() != x.size()) {
    m_x.resize(x.size());
    std::ranges::fill(m_x.values(), nowhere);
    m_x_seen.assign(x.size(), Vec2(nowhere, nowhere));
  }
  for (std::size_t block = 0; block < pattern.blocks(); ++block) {
    const std::size_t row = block * RowBlocks::lanes;
    const std::size_t end = std::min(row + RowBlocks::lanes, x.size());
    if (std::memcmp(&m_x_seen[row], &x[row], (end - row) * sizeof(Vec2)) == 0) continue;
    for (std::size_t i = row; i < end; ++i) {
      m_x_seen[i] = x[i];
      m_x.x()[i] = x[i].x();
      m_x.y()[i] = x[i].y();
    }
    if (all) continue;
    m_stale[block] = 1;
    if (pattern.meets_prescribed(block)) { // rows of clamped particles have no partners in the pattern
      for (std::size_t i = row; i < end; ++i)
        for (const std::uint32_t j : pairs.of(i)) m_stale[j / RowBlocks::lanes] = 1;
      continue;
    }
    for (const std::int32_t distance : pattern.distances(block))
      for (const std::size_t i : {row, row + RowBlocks::lanes - 1}) {
        const std::size_t partner =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + distance) / RowBlocks::lanes;
        if (partner < m_stale.size()) m_stale[partner] = 1; // not so where only other rows have one at that distance
      }
  }
}

/// Marks the blocks of rows that have another list of partners than before, or that have been added to.
void ViscosityRows::mark_changed(const RowPattern& pattern, std::span<const std::uint8_t> changed, DragSystem& A) {
  for (std::size_t i = 0; i < changed.size(); ++i) A.touched[i] |= changed[i];
  if (std::ranges::find(A.touched, 1) != A.touched.end()) A.pairs.fit(pattern, A.touched, m_stale);
}

/// Lets the drag resist changes of the velocities as well.
void ViscosityRows::add_relaxation(const EcmState& ecm, double theta, DragSystem& A) {
  const std::size_t n = ecm.size();
  split(ecm.v, n, m_v);
  if (m_zero.size() != n) m_zero.resize(n);
  if (m_drag.size() != n) m_drag.resize(n);
  A.pairs.residual(A.diagonal, m_zero, m_v.matrix, m_drag, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!A.prescribed[i]) A.F[i] -= theta / (1.0 + theta) * (A.F[i] + Vec2(m_drag.x()[i], m_drag.y()[i]));
  });
}

void ViscosityRows::assemble(const EcmState& ecm, std::span<const Vec2> x, const EcmParameters& p,
                             const Adjacency& pairs, const RowPattern& pattern, std::span<const std::uint8_t> changed,
                             double theta, DragSystem& A) {
  const std::size_t n = ecm.size();
  const bool all = m_stale.size() != pattern.blocks();
  mark_moved(x, pairs, pattern);
  A.diagonal.resize(n);
  const bool clamps_move = prescribe_clamps(ecm, A.F);
  if (clamps_move) std::ranges::fill(m_stale, std::uint8_t{1}); // their drag on others is added on the way
  if (all) {
    A.prescribed.assign(ecm.clamped.begin(), ecm.clamped.end());
    m_free.resize(n);
    for (std::size_t i = 0; i < n; ++i) m_free.x()[i] = ecm.clamped[i] ? 0.0F : 1.0F;
  }
  const PairDrag<float> law(p, Kernel(p.smoothing_length), ecm.V0);
  const auto fill = [&](std::size_t block, std::span<std::int32_t> distances, float* G) {
    const std::size_t row = block * RowBlocks::lanes;
    double D[RowBlocks::lanes];
    const std::size_t count = pair_drags(m_x, row, ecm.period_x, law, distances, G, D);
    for (std::size_t i = row; i < std::min(row + RowBlocks::lanes, n); ++i) {
      A.prescribed[i] = ecm.clamped[i] || D[i - row] == 0.0 ? 1 : 0; // without partners there is no force: it stays
      A.diagonal[i] = A.prescribed[i] ? 1.0 : D[i - row];
    }
    if (!pattern.meets_prescribed(block)) return count;
    if (clamps_move) add_drag_of_clamps(ecm, row, distances.first(count), G, A.F);
    return leave_out_clamps(m_free, row, distances.first(count), G);
  };
  if (all) {
    A.pairs.assign(pattern, fill);
  } else {
    mark_changed(pattern, changed, A);
    A.pairs.refill(pattern, m_stale, fill);
  }
  A.touched.assign(n, 0);
  if (theta != 0.0) add_relaxation(ecm, theta, A);
}

void assemble_viscosity(const EcmState& ecm, const EcmParameters& p, const RowPattern& pattern, DragSystem& A,
                        double theta) {
  ViscosityRows().assemble(ecm, ecm.x, p, {}, pattern, {}, theta, A);
}

} // namespace matrigrate
