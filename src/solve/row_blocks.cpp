#include "solve/row_blocks.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

constexpr std::size_t lanes = RowBlocks::lanes;

/// y = b - (D x - G x), or y = D x - G x without b, for the blocks from `block` on whose entries are given.
MATRIGRATE_SIMD
void products(std::span<const std::uint32_t> first, const std::int32_t* distance, const float* coefficient,
              std::size_t block, const Field& D, const Field* b, const Field& x, Field& y) {
  for (std::size_t n = 0; n + 1 < first.size(); ++n) {
    const std::size_t row = (block + n) * lanes;
    const float* at_x = x.x() + row;
    const float* at_y = x.y() + row;
    float sx[lanes] = {}, sy[lanes] = {}, tx[lanes] = {}, ty[lanes] = {}; // even and odd entries
    std::uint32_t k = first[n];
    for (; k + 1 < first[n + 1]; k += 2) {
      const float* c = coefficient + lanes * k;
      const float *x0 = at_x + distance[k], *x1 = at_x + distance[k + 1];
      const float *y0 = at_y + distance[k], *y1 = at_y + distance[k + 1];
      MATRIGRATE_LANES
      for (std::size_t l = 0; l < lanes; ++l) {
        sx[l] = std::fma(c[l], x0[l], sx[l]);
        sy[l] = std::fma(c[l], y0[l], sy[l]);
        tx[l] = std::fma(c[lanes + l], x1[l], tx[l]);
        ty[l] = std::fma(c[lanes + l], y1[l], ty[l]);
      }
    }
    if (k < first[n + 1]) {
      const float* c = coefficient + lanes * k;
      MATRIGRATE_LANES
      for (std::size_t l = 0; l < lanes; ++l) {
        sx[l] = std::fma(c[l], at_x[distance[k] + static_cast<std::ptrdiff_t>(l)], sx[l]);
        sy[l] = std::fma(c[l], at_y[distance[k] + static_cast<std::ptrdiff_t>(l)], sy[l]);
      }
    }
    const float* d = D.x() + row;
    MATRIGRATE_LANES
    for (std::size_t l = 0; l < lanes; ++l) {
      sx[l] = std::fma(d[l], at_x[l], -(sx[l] + tx[l]));
      sy[l] = std::fma(d[l], at_y[l], -(sy[l] + ty[l]));
    }
    if (b != nullptr) {
      const float *bx = b->x() + row, *by = b->y() + row;
      MATRIGRATE_LANES
      for (std::size_t l = 0; l < lanes; ++l) {
        sx[l] = bx[l] - sx[l];
        sy[l] = by[l] - sy[l];
      }
    }
    std::copy_n(sx, lanes, y.x() + row);
    std::copy_n(sy, lanes, y.y() + row);
  }
}

/// y = b - (D x - G x) in double precision; rows behind `size` are left alone.
MATRIGRATE_SIMD
void residuals(std::span<const std::uint32_t> first, const std::int32_t* distance, const float* coefficient,
               std::size_t block, std::size_t size, const double* D, const DoubleField& b, const DoubleField& x,
               DoubleField& y) {
  for (std::size_t n = 0; n + 1 < first.size(); ++n) {
    const std::size_t row = (block + n) * lanes;
    const double* at_x = x.x() + row;
    const double* at_y = x.y() + row;
    double sx[lanes] = {}, sy[lanes] = {};
    for (std::uint32_t k = first[n]; k < first[n + 1]; ++k) {
      const float* c = coefficient + lanes * k;
      const double *x0 = at_x + distance[k], *y0 = at_y + distance[k];
      MATRIGRATE_LANES
      for (std::size_t l = 0; l < lanes; ++l) {
        sx[l] = std::fma(static_cast<double>(c[l]), x0[l], sx[l]);
        sy[l] = std::fma(static_cast<double>(c[l]), y0[l], sy[l]);
      }
    }
    if (row + lanes <= size) {
      MATRIGRATE_LANES
      for (std::size_t l = 0; l < lanes; ++l) {
        y.x()[row + l] = b.x()[row + l] - std::fma(D[row + l], at_x[l], -sx[l]);
        y.y()[row + l] = b.y()[row + l] - std::fma(D[row + l], at_y[l], -sy[l]);
      }
      continue;
    }
    for (std::size_t l = 0; row + l < size; ++l) {
      y.x()[row + l] = b.x()[row + l] - std::fma(D[row + l], at_x[l], -sx[l]);
      y.y()[row + l] = b.y()[row + l] - std::fma(D[row + l], at_y[l], -sy[l]);
    }
  }
}

} // namespace

RowPattern::RowPattern(const Adjacency& pairs, std::span<const std::uint8_t> given) : m_size(pairs.size()) {
  m_first.push_back(0);
  const auto is_given = [given](std::size_t i) { return !given.empty() && given[i] != 0; };
  std::vector<std::int32_t> distances, of_row;
  for (std::size_t row = 0; row < m_size; row += lanes) {
    distances.clear();
    bool meets = false;
    for (std::size_t i = row; i < std::min(m_size, row + lanes); ++i) {
      if (is_given(i)) {
        meets = true;
        continue;
      }
      of_row.clear();
      for (const std::uint32_t j : pairs.of(i)) {
        of_row.push_back(static_cast<std::int32_t>(j) - static_cast<std::int32_t>(i));
        meets = meets || is_given(j);
      }
      if (of_row != distances) distances.insert(distances.end(), of_row.begin(), of_row.end());
    }
    std::ranges::sort(distances);
    distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
    m_distance.insert(m_distance.end(), distances.begin(), distances.end());
    m_first.push_back(static_cast<std::uint32_t>(m_distance.size()));
    m_meets_given.push_back(meets ? 1 : 0);
  }
}

void RowBlocks::assign(const Adjacency& pairs, std::span<const double> G) {
  const auto coefficient = [&](std::size_t i, std::int32_t distance) {
    if (i >= pairs.size()) return 0.0F;
    const auto row = pairs.of(i);
    const auto j = static_cast<std::int64_t>(i) + distance;
    const auto found = std::ranges::lower_bound(row, j, {}, [](std::uint32_t k) { return std::int64_t{k}; });
    if (found == row.end() || *found != j) return 0.0F;
    return static_cast<float>(G[pairs.first[i] + static_cast<std::size_t>(found - row.begin())]);
  };
  assign(RowPattern(pairs), [&](std::size_t block, std::span<std::int32_t> distances, float* values) {
    std::size_t count = 0;
    for (const std::int32_t distance : distances) {
      bool any = false;
      for (std::size_t l = 0; l < lanes; ++l) {
        values[lanes * count + l] = coefficient(block * lanes + l, distance);
        any = any || values[lanes * count + l] != 0.0F;
      }
      distances[count] = distance;
      if (any) ++count;
    }
    return count;
  });
}

float* RowBlocks::find(std::size_t i, std::size_t j) {
  const std::size_t block = i / lanes;
  Part& part = m_parts[block / blocks_per_part];
  const auto begin = part.distance.begin() + part.first[block % blocks_per_part];
  const auto end = part.distance.begin() + part.first[block % blocks_per_part + 1];
  const auto distance = static_cast<std::int32_t>(j) - static_cast<std::int32_t>(i);
  const auto found = std::lower_bound(begin, end, distance);
  if (found == end || *found != distance) return nullptr;
  float& G = part.coefficient[lanes * static_cast<std::size_t>(found - part.distance.begin()) + i % lanes];
  return G != 0.0F ? &G : nullptr;
}

template <class Body>
void RowBlocks::each_part(const Body& body) const {
  parallel_parts(m_parts.size(), [&](std::size_t p) { body(m_parts[p], p * blocks_per_part); });
}

void RowBlocks::multiply(const Field& D, const Field& x, Field& y) const {
  each_part([&](const Part& part, std::size_t block) {
    products(part.first, part.distance.data(), part.coefficient.data(), block, D, nullptr, x, y);
  });
}

void RowBlocks::residual(const Field& D, const Field& b, const Field& x, Field& y) const {
  each_part([&](const Part& part, std::size_t block) {
    products(part.first, part.distance.data(), part.coefficient.data(), block, D, &b, x, y);
  });
}

void RowBlocks::residual(std::span<const double> D, const DoubleField& b, const DoubleField& x, DoubleField& y) const {
  each_part([&](const Part& part, std::size_t block) {
    residuals(part.first, part.distance.data(), part.coefficient.data(), block, m_size, D.data(), b, x, y);
  });
}

} // namespace matrigrate
