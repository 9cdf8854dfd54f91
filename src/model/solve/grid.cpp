#include "solve/grid.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace matrigrate {

Grid::Grid(std::span<const Vec2> x, double spacing) : m_spacing(spacing) {
  Vec2 low = x.front();
  Vec2 high = low;
  for (const Vec2& a : x) {
    low = low.cwiseMin(a);
    high = high.cwiseMax(a);
  }
  m_low = low.array() - 0.5 * spacing;
  m_columns = static_cast<std::size_t>((high.x() - m_low.x()) / spacing) + 2;
  m_rows = static_cast<std::size_t>((high.y() - m_low.y()) / spacing) + 2;
  m_points = m_columns * m_rows;
  m_number.resize(m_points);
  std::iota(m_number.begin(), m_number.end(), 0);
}

Grid Grid::coarser() const {
  Grid grid;
  grid.m_spacing = 2.0 * m_spacing;
  grid.m_low = m_low;
  grid.m_columns = m_columns / 2 + 1;
  grid.m_rows = m_rows / 2 + 1;
  grid.m_points = grid.m_columns * grid.m_rows;
  grid.m_number.resize(grid.m_points);
  std::iota(grid.m_number.begin(), grid.m_number.end(), 0);
  return grid;
}

Grid Grid::without_nodes() const {
  Grid grid = *this;
  grid.m_around.clear();
  return grid;
}

std::vector<Vec2> Grid::points() const {
  std::vector<Vec2> x;
  for (std::size_t q = 0; q < m_number.size(); ++q) {
    if (m_number[q] < 0) continue;
    const std::size_t row = q / m_columns;
    const std::size_t column = q - row * m_columns;
    x.emplace_back(m_low + m_spacing * Vec2(static_cast<double>(column), static_cast<double>(row)));
  }
  return x;
}

void Grid::leave_out(std::span<const std::uint8_t> keep) {
  std::size_t count = 0;
  for (std::int32_t& number : m_number)
    if (number >= 0) number = keep[static_cast<std::size_t>(number)] != 0 ? static_cast<std::int32_t>(count++) : -1;
  m_points = count;
}

Grid::Around Grid::weigh(const Vec2& x) const {
  const Vec2 at = (x - m_low) / m_spacing;
  const double column = std::clamp(std::floor(at.x()), 0.0, static_cast<double>(m_columns - 2));
  const double row = std::clamp(std::floor(at.y()), 0.0, static_cast<double>(m_rows - 2));
  const double s = std::clamp(at.x() - column, 0.0, 1.0);
  const double t = std::clamp(at.y() - row, 0.0, 1.0);
  const std::size_t corner = static_cast<std::size_t>(row) * m_columns + static_cast<std::size_t>(column);
  const std::array<std::size_t, 4> points{corner, corner + 1, corner + m_columns, corner + m_columns + 1};
  const std::array<double, 4> weights{(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t};
  Around result;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::int32_t number = m_number[points[k]];
    if (number < 0) continue;
    result.point[k] = static_cast<std::uint32_t>(number);
    result.weight[k] = static_cast<float>(weights[k]);
  }
  return result;
}

void Grid::locate(std::span<const Vec2> x, std::span<const std::uint8_t> free) {
  m_around.resize(x.size());
  parallel_for(x.size(), [&](std::size_t i) { m_around[i] = free[i] != 0 ? weigh(x[i]) : Around{}; });
}

void Grid::take(const Grid& located, std::span<const std::uint32_t> nodes) {
  m_around.resize(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) m_around[i] = located.m_around[nodes[i]];
}

Eigen::SparseMatrix<double> Grid::P() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < m_around.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (m_around[i].weight[k] != 0.0F)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(m_around[i].point[k]), m_around[i].weight[k]);
  Eigen::SparseMatrix<double> P(static_cast<long>(m_around.size()), static_cast<long>(m_points));
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

void Grid::restrict_to(const Field& r, Field& a) const {
  a.set_zero();
  float* ax = a.x();
  float* ay = a.y();
  for (std::size_t i = 0; i < m_around.size(); ++i) { // in order: the same bits for any number of threads
    const Around& w = m_around[i];
    const float x = r.x()[i];
    const float y = r.y()[i];
    for (std::size_t k = 0; k < 4; ++k) {
      ax[w.point[k]] += w.weight[k] * x;
      ay[w.point[k]] += w.weight[k] * y;
    }
  }
}

} // namespace matrigrate
