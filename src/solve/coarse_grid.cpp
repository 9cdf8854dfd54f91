#include "solve/coarse_grid.hpp"

#include "base/parallel.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr double pinning = 10.0;     // own drag of a node that does not follow smooth fields, over that of particles
constexpr double least_share = 1e-3; // grid points with less of the largest diagonal carry no unknown

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Weights of the four corners at s, t.
std::array<double, 4> bilinear(double s, double t) {
  return {(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t};
}

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
  m_unknown.assign(m_columns * m_rows, -1);
  m_grid.assign(m_unknown.size() + m_columns + 2, Vec2::Zero());

  m_most_drag = pinning * *std::ranges::max_element(reference.diagonal);
  locate(reference);
  Triplets all;
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    const auto at_i = corners(m_places[i]);
    const auto at_j = corners(m_places[j]);
    const auto w_i = bilinear(m_places[i].s, m_places[i].t);
    const auto w_j = bilinear(m_places[j].s, m_places[j].t);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = 0; l < 4; ++l)
        if (w_i[k] != 0.0 && w_j[l] != 0.0)
          all.emplace_back(static_cast<int>(at_i[k]), static_cast<int>(at_j[l]), value * w_i[k] * w_j[l]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (is_given(reference, i)) continue;
    add(i, i, reference.diagonal[i]);
    for (std::uint32_t k = reference.pairs->first[i]; k < reference.pairs->first[i + 1]; ++k)
      if (reference.coupling[k] != 0.0) add(i, reference.pairs->index[k], -reference.coupling[k]);
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

CoarseGrid::Place CoarseGrid::place(const Vec2& x) const {
  const Vec2 at = (x - m_low) / m_spacing;
  const double column = std::clamp(std::floor(at.x()), 0.0, static_cast<double>(m_columns - 2));
  const double row = std::clamp(std::floor(at.y()), 0.0, static_cast<double>(m_rows - 2));
  return {static_cast<std::uint32_t>(static_cast<std::size_t>(row) * m_columns + static_cast<std::size_t>(column)),
          std::clamp(at.x() - column, 0.0, 1.0), std::clamp(at.y() - row, 0.0, 1.0)};
}

std::array<std::size_t, 4> CoarseGrid::corners(const Place& at) const {
  return {at.corner, at.corner + std::size_t{1}, at.corner + m_columns, at.corner + m_columns + 1};
}

void CoarseGrid::locate(const DragSystem& A) {
  const auto empty_cell = static_cast<std::uint32_t>(m_unknown.size());
  m_places.resize(A.size());
  parallel_for(A.size(), [&](std::size_t i) {
    m_places[i] = is_given(A, i) || is_pinned(A, i) ? Place{empty_cell} : place(A.position[i]);
  });
}

void CoarseGrid::restrict_to_grid(std::span<const Vec2> r) {
  std::ranges::fill(m_grid, Vec2::Zero());
  Corners sum;
  sum.fill(Vec2::Zero());
  Place at; // of the sum: neighbours in the list mostly share a cell
  const auto flush = [&] {
    const auto points = corners(at);
    for (std::size_t k = 0; k < 4; ++k) m_grid[points[k]] += sum[k];
    sum.fill(Vec2::Zero());
  };
  for (std::size_t i = 0; i < m_places.size(); ++i) { // in order: the same bits for any number of threads
    if (m_places[i].corner != at.corner) flush();
    at = m_places[i];
    const auto w = bilinear(at.s, at.t);
    for (std::size_t k = 0; k < 4; ++k) sum[k] += w[k] * r[i];
  }
  flush();
}

void CoarseGrid::add_correction(std::span<const Vec2> r, std::span<Vec2> z) {
  restrict_to_grid(r);
  for (std::size_t q = 0; q < m_unknown.size(); ++q)
    if (m_unknown[q] >= 0) m_r[static_cast<std::size_t>(m_unknown[q])] = m_grid[q];
  solve_factored(m_L, m_r);
  std::ranges::fill(m_grid, Vec2::Zero());
  for (std::size_t q = 0; q < m_unknown.size(); ++q)
    if (m_unknown[q] >= 0) m_grid[q] = m_r[static_cast<std::size_t>(m_unknown[q])];
  parallel_for(m_places.size(), [&](std::size_t i) {
    const auto points = corners(m_places[i]);
    const auto w = bilinear(m_places[i].s, m_places[i].t);
    z[i] += w[0] * m_grid[points[0]] + w[1] * m_grid[points[1]] + w[2] * m_grid[points[2]] + w[3] * m_grid[points[3]];
  });
}

} // namespace matrigrate
