#include "solve/elimination.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <utility>

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
  place_links(A);
  m_mixed.clear();
  m_updates.clear();
  m_rows.resize(m_cell_dofs);
  for (std::size_t a = 0; a < m_cell_dofs; ++a) {
    m_rows[a].clear();
    m_rows[a].push_back({static_cast<std::uint32_t>(a), A.diagonal[m_matrix + a] * Mat2::Identity()});
  }
  m_t.setZero(static_cast<long>(2 * m_cell_dofs));
  for (std::size_t m = 0; m < A.links.size(); ++m) add_link(A.links, m);
  for (std::size_t m = 0; m < A.directed.size(); ++m)
    add_term(A.directed.c[m], nodes(A.directed, m), weights(A.directed, m));
  m_sums.resize(m_mixed.size());
  factorise_cell();
}

/// Whether a term of A.links, over these nodes, is kept by its matrix node; any other becomes two directed terms.
bool Elimination::is_link(std::span<const std::uint32_t> node) const {
  const auto in_cell = [this](std::uint32_t k) { return k >= m_matrix; };
  return !node.empty() && node.size() <= max_entries && !in_cell(node[0])
         && std::ranges::all_of(node.subspan(1), in_cell);
}

/// Makes an entry of m_linked, with room for its drags, for each matrix node with links.
void Elimination::place_links(const DragSystem& A) {
  for (const Linked& linked : m_linked) m_linked_of[linked.node] = -1;
  m_linked.clear();
  if (m_matrix != A.pairs.size()) m_linked_of.assign(A.pairs.size(), -1);
  m_matrix = A.pairs.size();
  m_cell_dofs = A.size() - m_matrix;
  std::uint32_t room = 0;
  for (std::size_t m = 0; m < A.links.size(); ++m) {
    const auto node = nodes(A.links, m);
    if (!is_link(node)) continue;
    std::int32_t& place = m_linked_of[node[0]];
    if (place < 0) {
      place = static_cast<std::int32_t>(m_linked.size());
      m_linked.push_back({node[0], A.diagonal[node[0]], 0, 0});
    }
    m_linked[static_cast<std::size_t>(place)].first += static_cast<std::uint32_t>(node.size() - 1);
    room += static_cast<std::uint32_t>(node.size() - 1);
  }
  m_drags.resize(room);
  std::uint32_t first = 0; // `first` of each held its number of drags so far
  for (Linked& linked : m_linked) first += std::exchange(linked.first, first);
}

void Elimination::add_link(const DragTerms<double>& terms, std::size_t m) {
  const auto node = nodes(terms, m);
  const auto weight = weights(terms, m);
  const double c = terms.c[m];
  if (!is_link(node)) {
    for (const Vec2& e : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
      std::vector<Vec2> along;
      for (const double w : weight) along.emplace_back(w * e);
      add_term(c, node, along);
    }
    return;
  }
  Linked& linked = m_linked[static_cast<std::size_t>(m_linked_of[node[0]])];
  linked.diagonal += c * weight[0] * weight[0];
  for (std::size_t p = 1; p < node.size(); ++p) {
    const std::uint32_t a = cell_dof(node[p]);
    Drag* drag = m_drags.data() + linked.first;
    Drag* const end = drag + linked.count;
    while (drag != end && drag->first != a) ++drag;
    if (drag == end) {
      *drag = {a, 0.0};
      ++linked.count;
    }
    drag->second -= c * weight[0] * weight[p];
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
  for (Block& entry : row) // the one on the diagonal is the first
    if (entry.column == b) return entry.value;
  return row.emplace_back(Block{b, Mat2::Zero()}).value;
}

void Elimination::diagonals(const DragSystem& A, Field& diagonal, Field& smoother) {
  float *D = diagonal.x(), *x = smoother.x(), *y = smoother.y();
  const auto bound = [=](std::size_t k, double b) { x[k] = y[k] = static_cast<float>(1.0 / b); };
  const double* from = A.diagonal.data();
  const auto begin = [=](std::size_t k) {
    D[k] = static_cast<float>(from[k]);
    bound(k, from[k]);
  };
  parallel_for(m_matrix, begin, light_grain);
  for (const Linked& linked : m_linked) {
    D[linked.node] = static_cast<float>(linked.diagonal);
    bound(linked.node, linked.diagonal);
  }
  m_bound.resize(m_matrix);
  const auto each_in_matrix = [this](std::size_t m, const auto& visit) {
    for (std::uint32_t e = m_mixed.first[m]; e < m_mixed.first[m + 1]; ++e)
      if (m_mixed.node[e] < m_matrix) visit(m_mixed.node[e], m_mixed.weight[e].norm());
  };
  for (std::size_t m = 0; m < m_mixed.size(); ++m)
    each_in_matrix(m, [&](std::uint32_t k, double) {
      const std::int32_t place = m_linked_of[k];
      m_bound[k] = place < 0 ? A.diagonal[k] : m_linked[static_cast<std::size_t>(place)].diagonal;
    });
  for (std::size_t m = 0; m < m_mixed.size(); ++m) {
    double sum = 0.0;
    each_in_matrix(m, [&](std::uint32_t, double weight) { sum += weight; });
    each_in_matrix(m, [&](std::uint32_t k, double weight) { m_bound[k] += m_mixed.c[m] * sum * weight; });
  }
  for (std::size_t m = 0; m < m_mixed.size(); ++m)
    each_in_matrix(m, [&](std::uint32_t k, double) { bound(k, m_bound[k]); });
}

void Elimination::factorise_cell() {
  if (m_cell_dofs == 0) return;
  const auto size = static_cast<long>(2 * m_cell_dofs);
  std::size_t entries = 0;
  for (auto& row : m_rows) {
    std::ranges::sort(row, {}, &Block::column);
    entries += 4 * row.size();
  }
  m_next.resize(size, size); // column a of the upper half is row a of the lower
  m_next.reserve(static_cast<long>(entries));
  for (std::size_t a = 0; a < m_cell_dofs; ++a)
    for (long e = 0; e < 2; ++e) {
      const long column = 2 * static_cast<long>(a) + e;
      m_next.startVec(column);
      for (const Block& entry : m_rows[a])
        for (long d = 0; d < 2; ++d) {
          const long row = 2L * entry.column + d;
          if (row <= column) m_next.insertBack(row, column) = entry.value(e, d);
        }
    }
  m_next.finalize();
  if (!same_pattern(m_next, m_pattern)) m_factor.analyzePattern(m_next); // depends on the pattern alone
  m_factor.factorize(m_next);
  m_pattern.swap(m_next);
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
  m_solved = m_factor.solve(m_t);
  m_t.swap(m_solved);
  for (const Update& update : m_updates) m_t -= update.factor * update.w.dot(m_t) * update.solved;
}

/// m_t += A_cm x, where at(k) is x at node k of the matrix.
template <class At>
void Elimination::gather(const At& at) {
  for (const Linked& linked : m_linked) {
    const Vec2 x = at(linked.node);
    for (const auto& [a, drag] : drags(linked)) m_t.segment<2>(2L * a) -= drag * x;
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
  constexpr std::size_t grain = 128;
  const auto add_linked = [&](std::size_t k) {
    Vec2 y = Vec2::Zero();
    for (const auto& [a, drag] : drags(m_linked[k])) y += drag * m_t.segment<2>(2L * a);
    add(m_linked[k].node, y);
  };
  parallel_for(m_linked.size(), add_linked, grain);
  for (std::size_t m = 0; m < m_mixed.size(); ++m) {
    double sum = m_sums[m];
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] >= m_matrix) sum -= m_mixed.weight[k].dot(m_t.segment<2>(2L * cell_dof(m_mixed.node[k])));
    for (std::uint32_t k = m_mixed.first[m]; k < m_mixed.first[m + 1]; ++k)
      if (m_mixed.node[k] < m_matrix) add(m_mixed.node[k], m_mixed.c[m] * sum * m_mixed.weight[k]);
  }
}

void Elimination::lump(const DragSystem& A, LumpedLinks& links) const {
  links.clear(std::span(A.diagonal).subspan(m_matrix));
  for (const Linked& linked : m_linked) links.add(linked.node, drags(linked));
  links.close();
}

void Elimination::multiply(const Field& x) {
  if (m_linked.empty() && m_mixed.size() == 0) return;
  m_t.setZero();
  gather([&x](std::uint32_t k) { return Vec2(x.x()[k], x.y()[k]); });
  if (m_cell_dofs > 0) solve_cell();
}

void Elimination::add_product(float factor, Field& y) {
  if (m_linked.empty() && m_mixed.size() == 0) return;
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
