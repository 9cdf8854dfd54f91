#include "solve/elimination.hpp"

#include <algorithm>

namespace matrigrate {

namespace {

constexpr std::size_t max_entries = 64; // of a term that goes into A_cc

template <class Weight>
std::span<const std::uint32_t> nodes(const DragTerms<Weight>& terms, std::size_t m) {
  return {terms.node.data() + terms.first[m], terms.node.data() + terms.first[m + 1]};
}
template <class Weight>
std::span<const Weight> weights(const DragTerms<Weight>& terms, std::size_t m) {
  return {terms.weight.data() + terms.first[m], terms.weight.data() + terms.first[m + 1]};
}

bool same_pattern(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) {
  if (a.cols() != b.cols() || a.nonZeros() != b.nonZeros()) return false;
  return std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr())
         && std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

} // namespace

void Elimination::factorise(const DragSystem& A) {
  m_matrix = A.pairs.size();
  m_cell_dofs = A.size() - m_matrix;
  m_diagonal.assign(A.diagonal.begin(), A.diagonal.begin() + static_cast<std::ptrdiff_t>(m_matrix));
  m_linked_of.assign(m_matrix, -1);
  m_linked.clear();
  m_mixed.clear();
  m_updates.clear();
  m_rows.resize(m_cell_dofs);
  for (std::size_t a = 0; a < m_cell_dofs; ++a) {
    m_rows[a].clear();
    block(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(a)) = A.diagonal[m_matrix + a] * Mat2::Identity();
  }
  m_t.setZero(static_cast<long>(2 * m_cell_dofs));
  for (std::size_t m = 0; m < A.links.size(); ++m) add_link(A.links, m);
  for (std::size_t m = 0; m < A.directed.size(); ++m)
    add_term(A.directed.c[m], nodes(A.directed, m), weights(A.directed, m));
  m_sums.resize(m_mixed.size());
  set_bound();
  factorise_cell();
}

/// A link of one matrix node is kept by that node; any other becomes two directed terms.
void Elimination::add_link(const DragTerms<double>& terms, std::size_t m) {
  const auto node = nodes(terms, m);
  const auto weight = weights(terms, m);
  const double c = terms.c[m];
  const auto in_matrix = std::ranges::count_if(node, [this](std::uint32_t k) { return k < m_matrix; });
  if (in_matrix != 1 || node[0] >= m_matrix || node.size() > max_entries) {
    for (const Vec2& e : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
      std::vector<Vec2> along;
      for (const double w : weight) along.emplace_back(w * e);
      add_term(c, node, along);
    }
    return;
  }
  const std::uint32_t k = node[0];
  m_diagonal[k] += c * weight[0] * weight[0];
  if (m_linked_of[k] < 0) {
    m_linked_of[k] = static_cast<std::int32_t>(m_linked.size());
    m_linked.push_back({k, {}});
  }
  auto& drags = m_linked[static_cast<std::size_t>(m_linked_of[k])].drag;
  for (std::size_t p = 1; p < node.size(); ++p) {
    const std::uint32_t a = cell_dof(node[p]);
    const auto at = std::find_if(drags.rbegin(), drags.rend(), [a](const auto& d) { return d.first == a; });
    double& drag = at != drags.rend() ? at->second : drags.emplace_back(a, 0.0).second;
    drag -= c * weight[0] * weight[p];
    for (std::size_t q = 1; q < node.size(); ++q)
      if (node[q] <= node[p]) block(a, cell_dof(node[q])).diagonal().array() += c * weight[p] * weight[q];
  }
}

void Elimination::add_term(double c, std::span<const std::uint32_t> node, std::span<const Vec2> weight) {
  const auto in_matrix = [this](std::uint32_t k) { return k < m_matrix; };
  if (std::ranges::any_of(node, in_matrix)) {
    for (std::size_t p = 0; p < node.size(); ++p) m_mixed.add_entry(node[p], weight[p]);
    m_mixed.close(c);
  }
  if (node.size() > max_entries) {
    Update update{Eigen::VectorXd::Zero(static_cast<long>(2 * m_cell_dofs)), {}, c};
    for (std::size_t p = 0; p < node.size(); ++p)
      if (!in_matrix(node[p])) update.w.segment<2>(2L * cell_dof(node[p])) += weight[p];
    m_updates.push_back(std::move(update));
    return;
  }
  for (std::size_t p = 0; p < node.size(); ++p)
    for (std::size_t q = 0; q < node.size(); ++q)
      if (!in_matrix(node[p]) && !in_matrix(node[q]) && node[q] <= node[p])
        block(cell_dof(node[p]), cell_dof(node[q])) += c * weight[p] * weight[q].transpose();
}

Mat2& Elimination::block(std::uint32_t a, std::uint32_t b) {
  auto& row = m_rows[a];
  for (Block& entry : row)
    if (entry.column == b) return entry.value;
  return row.emplace_back(Block{b, Mat2::Zero()}).value;
}

void Elimination::set_bound() {
  m_bound = m_diagonal;
  for (std::size_t m = 0; m < m_mixed.size(); ++m) {
    double sum = 0.0;
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] < m_matrix) sum += m_mixed.weight[k].norm();
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] < m_matrix) m_bound[m_mixed.node[k]] += m_mixed.c[m] * sum * m_mixed.weight[k].norm();
  }
}

void Elimination::factorise_cell() {
  if (m_cell_dofs == 0) return;
  const auto size = static_cast<long>(2 * m_cell_dofs);
  std::size_t entries = 0;
  for (auto& row : m_rows) {
    std::ranges::sort(row, {}, &Block::column);
    entries += 4 * row.size();
  }
  Eigen::SparseMatrix<double> matrix(size, size); // column a of the upper half is row a of the lower
  matrix.reserve(static_cast<long>(entries));
  for (std::size_t a = 0; a < m_cell_dofs; ++a)
    for (long e = 0; e < 2; ++e) {
      const long column = 2 * static_cast<long>(a) + e;
      matrix.startVec(column);
      for (const Block& entry : m_rows[a])
        for (long d = 0; d < 2; ++d) {
          const long row = 2L * entry.column + d;
          if (row <= column) matrix.insertBack(row, column) = entry.value(e, d);
        }
    }
  matrix.finalize();
  if (!same_pattern(matrix, m_pattern)) m_factor.analyzePattern(matrix); // depends on the pattern alone
  m_factor.factorize(matrix);
  m_pattern.swap(matrix);
  std::vector<Update> updates;
  updates.swap(m_updates);
  for (Update& update : updates) { // each with the ones before in place
    m_t = update.w;
    solve_cell();
    update.factor /= 1.0 + update.factor * update.w.dot(m_t);
    update.solved = m_t;
    m_updates.push_back(std::move(update));
  }
}

/// m_t := A_cc^-1 m_t.
void Elimination::solve_cell() {
  m_t = m_factor.solve(m_t).eval();
  for (const Update& update : m_updates) m_t -= update.factor * update.w.dot(m_t) * update.solved;
}

/// m_t += A_cm x, where at(k) is x at node k of the matrix.
template <class At>
void Elimination::gather(const At& at) {
  for (const Linked& linked : m_linked) {
    const Vec2 x = at(linked.node);
    for (const auto& [a, drag] : linked.drag) m_t.segment<2>(2L * a) -= drag * x;
  }
  for (std::size_t m = 0; m < m_mixed.size(); ++m) {
    double sum = 0.0;
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] < m_matrix) sum += m_mixed.weight[k].dot(at(m_mixed.node[k]));
    m_sums[m] = sum;
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] >= m_matrix)
        m_t.segment<2>(2L * cell_dof(m_mixed.node[k])) += m_mixed.c[m] * sum * m_mixed.weight[k];
  }
}

/// add(k, y) for y = -A_mc m_t at the nodes k of the matrix, and that of the mixed terms within the matrix for m_sums.
template <class Add>
void Elimination::scatter(const Add& add) {
  for (const Linked& linked : m_linked) {
    Vec2 y = Vec2::Zero();
    for (const auto& [a, drag] : linked.drag) y += drag * m_t.segment<2>(2L * a);
    add(linked.node, y);
  }
  for (std::size_t m = 0; m < m_mixed.size(); ++m) {
    double sum = m_sums[m];
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] >= m_matrix) sum -= m_mixed.weight[k].dot(m_t.segment<2>(2L * cell_dof(m_mixed.node[k])));
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] < m_matrix) add(m_mixed.node[k], m_mixed.c[m] * sum * m_mixed.weight[k]);
  }
}

void Elimination::lump(const DragSystem& A, std::span<const Vec2> X, LumpedLinks& links) const {
  links.clear(std::span(A.diagonal).subspan(m_matrix));
  for (const Linked& linked : m_linked) links.add(X[linked.node], linked.drag);
  links.close();
}

void Elimination::add_product(float factor, const Field& x, Field& y) {
  if (m_linked.empty() && m_mixed.size() == 0) return;
  m_t.setZero();
  gather([&x](std::uint32_t k) { return Vec2(x.x()[k], x.y()[k]); });
  if (m_cell_dofs > 0) solve_cell();
  scatter([&y, factor](std::uint32_t k, const Vec2& a) {
    y.x()[k] += factor * static_cast<float>(a.x());
    y.y()[k] += factor * static_cast<float>(a.y());
  });
}

void Elimination::reduce(NodeVectors& r) {
  if (m_cell_dofs == 0) return;
  for (std::size_t a = 0; a < m_cell_dofs; ++a) m_t.segment<2>(static_cast<long>(2 * a)) = r.cell_dofs[a];
  solve_cell();
  std::ranges::fill(m_sums, 0.0);
  scatter([&r](std::uint32_t k, const Vec2& a) { r.add(k, a); });
}

void Elimination::recover(std::span<const Vec2> r_c, const Field& v_m, std::span<Vec2> v_c) {
  if (m_cell_dofs == 0) return;
  m_t.setZero();
  gather([&v_m](std::uint32_t k) { return Vec2(v_m.x()[k], v_m.y()[k]); });
  for (std::size_t a = 0; a < m_cell_dofs; ++a) {
    auto t = m_t.segment<2>(static_cast<long>(2 * a));
    t = r_c[a] - t;
  }
  solve_cell();
  for (std::size_t a = 0; a < m_cell_dofs; ++a) v_c[a] = m_t.segment<2>(static_cast<long>(2 * a));
}

} // namespace matrigrate
