#include "solve/patch.hpp"

namespace matrigrate {

namespace {

constexpr double least_share = 0.1;        // of terms in the diagonal of a matrix node of the patch
constexpr std::uint32_t most_entries = 64; // of a term that is part of it

using Triplets = std::vector<Eigen::Triplet<double>>;

Mat2 outer(double a, double b) { return a * b * Mat2::Identity(); }
Mat2 outer(const Vec2& a, const Vec2& b) { return a * b.transpose(); }

template <class Weight>
void add_terms(const DragTerms<Weight>& terms, const std::vector<std::int32_t>& local, Triplets& entries) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    if (terms.first[m + 1] - terms.first[m] > most_entries) continue;
    for (std::uint32_t k = terms.first[m]; k < terms.first[m + 1]; ++k)
      for (std::uint32_t l = terms.first[m]; l < terms.first[m + 1]; ++l) {
        const int row = 2 * local[terms.node[k]];
        const int column = 2 * local[terms.node[l]];
        if (row < 0 || column < 0 || row < column) continue;
        const Mat2 block = terms.c[m] * outer(terms.weight[k], terms.weight[l]);
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            if (row + a >= column + b) entries.emplace_back(row + a, column + b, block(a, b));
      }
  }
}

} // namespace

void Patch::factorise(const DragSystem& A, std::span<const double> diagonal) {
  m_nodes.clear();
  m_local.assign(A.size(), -1);
  for (std::size_t i = 0; i < A.size(); ++i) {
    const double terms = diagonal[i] - A.diagonal[i];
    if (i < A.pairs->size() && terms < least_share * A.diagonal[i]) continue;
    m_local[i] = static_cast<std::int32_t>(m_nodes.size());
    m_nodes.push_back(static_cast<std::uint32_t>(i));
  }
  if (m_nodes.empty()) return;
  Triplets entries;
  for (const std::uint32_t i : m_nodes) {
    const int row = 2 * m_local[i];
    for (int a = 0; a < 2; ++a) entries.emplace_back(row + a, row + a, A.diagonal[i]);
    if (i >= A.pairs->size()) continue;
    for (std::uint32_t k = A.pairs->first[i]; k < A.pairs->first[i + 1]; ++k) {
      const int column = 2 * m_local[A.pairs->index[k]];
      if (column < 0 || column >= row || A.coupling[k] == 0.0) continue;
      for (int a = 0; a < 2; ++a) entries.emplace_back(row + a, column + a, -A.coupling[k]);
    }
  }
  add_terms(A.links, m_local, entries);
  add_terms(A.directed, m_local, entries);
  const auto size = static_cast<long>(2 * m_nodes.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  m_factor.compute(matrix);
  m_r.resize(size);
}

void Patch::solve(std::span<const Vec2> r, std::span<Vec2> z) {
  if (m_nodes.empty()) return;
  for (std::size_t k = 0; k < m_nodes.size(); ++k) m_r.segment<2>(static_cast<long>(2 * k)) = r[m_nodes[k]];
  const Eigen::VectorXd solved = m_factor.solve(m_r);
  for (std::size_t k = 0; k < m_nodes.size(); ++k) z[m_nodes[k]] = solved.segment<2>(static_cast<long>(2 * k));
}

} // namespace matrigrate
