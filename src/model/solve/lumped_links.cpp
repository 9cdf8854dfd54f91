#include "solve/lumped_links.hpp"

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
    const Grid::Around& at = grid.around(k);
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

void LumpedLinks::multiply(Field& u) {
  m_sum.assign(2 * m_T.size(), 0.0F);
  for (std::size_t k = 0; k < size(); ++k)
    for (std::uint32_t e = m_first[k]; e < m_first[k + 1]; ++e) {
      m_sum[2 * m_cell_dofs[e]] += m_drag[e] * u.x()[k];
      m_sum[2 * m_cell_dofs[e] + 1] += m_drag[e] * u.y()[k];
    }
  for (std::size_t a = 0; a < m_T.size(); ++a) {
    m_sum[2 * a] *= m_T[a];
    m_sum[2 * a + 1] *= m_T[a];
  }
  for (std::size_t k = 0; k < size(); ++k) {
    float x = m_g[k] * u.x()[k];
    float y = m_g[k] * u.y()[k];
    for (std::uint32_t e = m_first[k]; e < m_first[k + 1]; ++e) {
      x -= m_drag[e] * m_sum[2 * m_cell_dofs[e]];
      y -= m_drag[e] * m_sum[2 * m_cell_dofs[e] + 1];
    }
    u.x()[k] = x;
    u.y()[k] = y;
  }
}

} // namespace matrigrate
