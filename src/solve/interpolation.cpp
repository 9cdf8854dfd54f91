#include "solve/interpolation.hpp"

#include "base/parallel.hpp"

namespace matrigrate {

Interpolation::Interpolation(const Grid& grid, std::size_t nodes) : m_grid(grid), m_first(grid.size() + 1, 0) {
  const auto each = [&](const auto& use) {
    for (std::uint32_t i = 0; i < nodes; ++i)
      for (std::size_t k = 0; k < 4; ++k)
        if (grid.around(i).weight[k] != 0.0F) use(i, grid.around(i).point[k], grid.around(i).weight[k]);
  };
  each([&](std::uint32_t, std::uint32_t q, float) { ++m_first[q + 1]; });
  for (std::size_t q = 0; q < grid.size(); ++q) m_first[q + 1] += m_first[q];
  m_node.resize(m_first.back());
  m_weight.resize(m_first.back());
  std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
  each([&](std::uint32_t i, std::uint32_t q, float weight) {
    m_node[next[q]] = i;
    m_weight[next[q]++] = weight;
  });
}

void Interpolation::restrict_to(const Field& r, Field& a) const {
  const float *x = r.x(), *y = r.y();
  float *to_x = a.x(), *to_y = a.y();
  parallel_for(m_grid.size(), [=, this](std::size_t q) {
    float sum_x = 0.0F, sum_y = 0.0F;
    for (std::uint32_t e = m_first[q]; e < m_first[q + 1]; ++e) {
      sum_x += m_weight[e] * x[m_node[e]];
      sum_y += m_weight[e] * y[m_node[e]];
    }
    to_x[q] = sum_x;
    to_y[q] = sum_y;
  });
}

void Interpolation::interpolate(const Field& a, Field& z) const { m_grid.interpolate(a, z); }

} // namespace matrigrate
