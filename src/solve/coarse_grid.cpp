#include "solve/coarse_grid.hpp"

#include "base/parallel.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr double least_share = 1e-3; // grid points with less of the largest diagonal carry no unknown

using Triplets = std::vector<Eigen::Triplet<double>>;

struct Factor {
  Eigen::SparseMatrix<double> L;      // of the permuted matrix
  std::vector<std::int32_t> position; // of an unknown in it
};

/// Cholesky factor with a fill-reducing order; the matrix is positive definite because the reference is.
Factor factorise(const Triplets& entries, long size) {
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(matrix);
  Factor factor{cholesky.matrixL(), {}};
  const auto& order = cholesky.permutationP().indices();
  factor.position.assign(order.data(), order.data() + order.size());
  return factor;
}

/// x := (L L^T)^-1 x, both components at once.
void solve_factored(const Eigen::SparseMatrix<double>& L, std::vector<Vec2>& x) {
  const int* first = L.outerIndexPtr();
  const int* row = L.innerIndexPtr();
  const double* value = L.valuePtr();
  const auto n = static_cast<std::size_t>(L.cols());
  for (std::size_t j = 0; j < n; ++j) { // the diagonal comes first in its column
    x[j] /= value[first[j]];
    for (int k = first[j] + 1; k < first[j + 1]; ++k) x[static_cast<std::size_t>(row[k])] -= value[k] * x[j];
  }
  for (std::size_t j = n; j-- > 0;) {
    for (int k = first[j] + 1; k < first[j + 1]; ++k) x[j] -= value[k] * x[static_cast<std::size_t>(row[k])];
    x[j] /= value[first[j]];
  }
}

} // namespace

bool is_given(const DragSystem& A, std::size_t i) {
  if (i >= A.pairs->size()) return false;
  for (std::uint32_t k = A.pairs->first[i]; k < A.pairs->first[i + 1]; ++k)
    if (A.coupling[k] != 0.0) return false;
  return true;
}

CoarseGrid::CoarseGrid(const DragSystem& reference, double spacing) : m_spacing(spacing) {
  const std::size_t n = reference.pairs->size();
  Vec2 low = reference.position[0];
  Vec2 high = low;
  for (std::size_t i = 0; i < n; ++i) {
    low = low.cwiseMin(reference.position[i]);
    high = high.cwiseMax(reference.position[i]);
  }
  m_low = low.array() - 0.5 * spacing;
  m_columns = static_cast<std::size_t>((high.x() - m_low.x()) / spacing) + 2;
  m_rows = static_cast<std::size_t>((high.y() - m_low.y()) / spacing) + 2;
  m_unknown.assign(m_columns * m_rows, 0);
  for (std::size_t q = 0; q < m_unknown.size(); ++q) m_unknown[q] = static_cast<std::int32_t>(q);

  locate(reference);
  Triplets all;
  const auto add = [&](const Weights& a, const Weights& b, double value) {
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = 0; l < 4; ++l)
        if (a.weight[k] != 0.0 && b.weight[l] != 0.0)
          all.emplace_back(static_cast<int>(a.point[k]), static_cast<int>(b.point[l]),
                           value * a.weight[k] * b.weight[l]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (is_given(reference, i)) continue;
    add(m_weights[i], m_weights[i], reference.diagonal[i]);
    for (std::uint32_t k = reference.pairs->first[i]; k < reference.pairs->first[i + 1]; ++k)
      add(m_weights[i], m_weights[reference.pairs->index[k]], -reference.coupling[k]);
  }
  std::vector<double> diagonal(m_unknown.size(), 0.0);
  for (const auto& entry : all)
    if (entry.row() == entry.col()) diagonal[static_cast<std::size_t>(entry.row())] += entry.value();
  const double least = least_share * *std::ranges::max_element(diagonal);
  std::int32_t count = 0;
  for (std::size_t q = 0; q < m_unknown.size(); ++q) m_unknown[q] = diagonal[q] > least ? count++ : -1;
  Triplets kept;
  for (const auto& entry : all) {
    const std::int32_t row = m_unknown[static_cast<std::size_t>(entry.row())];
    const std::int32_t column = m_unknown[static_cast<std::size_t>(entry.col())];
    if (row >= 0 && column >= 0) kept.emplace_back(row, column, entry.value());
  }
  Factor factor = factorise(kept, count);
  m_L = std::move(factor.L);
  for (std::int32_t& unknown : m_unknown)
    if (unknown >= 0) unknown = factor.position[static_cast<std::size_t>(unknown)];
  m_r.resize(static_cast<std::size_t>(count));
}

CoarseGrid::Weights CoarseGrid::weights(const Vec2& x) const {
  const Vec2 at = (x - m_low) / m_spacing;
  const double column = std::clamp(std::floor(at.x()), 0.0, static_cast<double>(m_columns - 2));
  const double row = std::clamp(std::floor(at.y()), 0.0, static_cast<double>(m_rows - 2));
  const double s = std::clamp(at.x() - column, 0.0, 1.0);
  const double t = std::clamp(at.y() - row, 0.0, 1.0);
  const std::size_t corner = static_cast<std::size_t>(row) * m_columns + static_cast<std::size_t>(column);
  const std::array<std::size_t, 4> points{corner, corner + 1, corner + m_columns, corner + m_columns + 1};
  const std::array<double, 4> values{(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t};
  Weights w;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t unknown = m_unknown[points[k]];
    if (unknown < 0) continue;
    w.point[k] = static_cast<std::uint32_t>(unknown);
    w.weight[k] = values[k];
  }
  return w;
}

void CoarseGrid::locate(const DragSystem& A) {
  m_weights.resize(A.size());
  parallel_for(A.size(), [&](std::size_t i) { m_weights[i] = is_given(A, i) ? Weights{} : weights(A.position[i]); });
}

void CoarseGrid::add_correction(std::span<const Vec2> r, std::span<Vec2> z) {
  std::ranges::fill(m_r, Vec2::Zero());
  for (std::size_t i = 0; i < m_weights.size(); ++i) // in order: the same bits for any number of threads
    for (std::size_t k = 0; k < 4; ++k) m_r[m_weights[i].point[k]] += m_weights[i].weight[k] * r[i];
  solve_factored(m_L, m_r);
  parallel_for(m_weights.size(), [&](std::size_t i) {
    for (std::size_t k = 0; k < 4; ++k) z[i] += m_weights[i].weight[k] * m_r[m_weights[i].point[k]];
  });
}

} // namespace matrigrate
