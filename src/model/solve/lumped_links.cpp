#include "solve/lumped_links.hpp"

#include "base/pack.hpp"

namespace matrigrate {

void LumpedLinks::clear(std::span<const double> own) {
  m_nodes.clear();
  m_g.clear();
  m_first.assign(1, 0);
  m_cell_dofs.clear();
  m_drag.clear();
  m_T.assign(own.begin(), own.end());
}

void LumpedLinks::add(std::uint32_t node, std::span<const std::pair<std::uint32_t, double>> drags) {
  double sum = 0.0;
  for (const auto& [a, drag] : drags) {
    if (drag <= 0.0) continue;
    sum += drag;
    m_T[a] += static_cast<float>(drag);
    m_cell_dofs.push_back(a);
    m_drag.push_back(static_cast<float>(drag));
  }
  m_nodes.push_back(node);
  m_g.push_back(static_cast<float>(sum));
  m_first.push_back(static_cast<std::uint32_t>(m_cell_dofs.size()));
}

void LumpedLinks::close() {
  for (float& T : m_T) T = 1.0F / T;
}

void LumpedLinks::add_to(const Grid& grid, Eigen::MatrixXf& A) const {
  Eigen::MatrixXf g = Eigen::MatrixXf::Zero(A.rows(), static_cast<long>(m_T.size())); // P^T g_a
  for (std::size_t k = 0; k < size(); ++k) {
    const Grid::Around& at = grid.around()[k];
    for (std::size_t p = 0; p < 4; ++p) {
      for (std::size_t q = 0; q < 4; ++q)
        if (at.point[q] <= at.point[p]) A(at.point[p], at.point[q]) += m_g[k] * at.weight[p] * at.weight[q];
      for (std::uint32_t e = m_first[k]; e < m_first[k + 1]; ++e)
        g(at.point[p], m_cell_dofs[e]) += at.weight[p] * m_drag[e];
    }
  }
  std::vector<long> touched;
  for (long a = 0; a < g.cols(); ++a) {
    touched.clear();
    for (long p = 0; p < g.rows(); ++p)
      if (g(p, a) != 0.0F) touched.push_back(p);
    for (auto q = touched.begin(); q != touched.end(); ++q)
      for (auto p = q; p != touched.end(); ++p) A(*p, *q) -= m_T[static_cast<std::size_t>(a)] * g(*p, a) * g(*q, a);
  }
}

MATRIGRATE_SIMD
void LumpedLinks::multiply(const Grid& grid, const Field& x) {
  m_sum.assign(2 * m_T.size(), 0.0F);
  m_force.resize(2 * size());
  float *const sum = m_sum.data(), *const force = m_force.data();
  const float *const a_x = x.x(), *const a_y = x.y(), *const g = m_g.data(), *const drag = m_drag.data();
  const std::uint32_t *const first = m_first.data(), *const cell_dof = m_cell_dofs.data();
  const Grid::Around* const around = grid.around().data();
  const std::size_t nodes = size();
  for (std::size_t k = 0; k < nodes; ++k) {
    TwoFloats u{};
    for (std::size_t q = 0; q < 4; ++q)
      u += around[k].weight[q] * TwoFloats{a_x[around[k].point[q]], a_y[around[k].point[q]]};
    store_pack(g[k] * u, force + 2 * k);
    for (std::uint32_t e = first[k], end = first[k + 1]; e < end; ++e) {
      float* const to = sum + 2 * std::size_t{cell_dof[e]};
      TwoFloats a;
      load(to, a);
      store_pack(a + drag[e] * u, to);
    }
  }
  for (std::size_t a = 0; a < m_T.size(); ++a) {
    sum[2 * a] *= m_T[a];
    sum[2 * a + 1] *= m_T[a];
  }
  for (std::size_t k = 0; k < nodes; ++k) {
    TwoFloats f;
    load(force + 2 * k, f);
    for (std::uint32_t e = first[k], end = first[k + 1]; e < end; ++e) {
      TwoFloats a;
      load(sum + 2 * std::size_t{cell_dof[e]}, a);
      f -= drag[e] * a;
    }
    store_pack(f, force + 2 * k);
  }
}

void LumpedLinks::subtract_from(const Grid& grid, Field& r) const {
  float *const r_x = r.x(), *const r_y = r.y();
  for (std::size_t k = 0; k < size(); ++k) {
    const Grid::Around& at = grid.around()[k];
    for (std::size_t q = 0; q < 4; ++q) {
      r_x[at.point[q]] -= at.weight[q] * m_force[2 * k];
      r_y[at.point[q]] -= at.weight[q] * m_force[2 * k + 1];
    }
  }
}

} // namespace matrigrate
