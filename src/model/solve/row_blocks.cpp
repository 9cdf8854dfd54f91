#include "solve/row_blocks.hpp"

#include "base/pack.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace matrigrate {

namespace {

constexpr std::size_t lanes = RowBlocks::lanes;

/// y = b - (D x - G x), or y = D x - G x without b, for the blocks from `block` on whose entries are given.
MATRIGRATE_SIMD
void products(std::span<const std::uint32_t> first, std::span<const std::uint32_t> count, const std::int32_t* distance,
              const float* coefficient, std::size_t block, const Field& D, const Field* b, const Field& x, Field& y) {
  for (std::size_t n = 0; n < count.size(); ++n) {
    const std::size_t row = (block + n) * lanes;
    const float* at_x = x.x() + row;
    const float* at_y = x.y() + row;
    Floats sum_x{}, sum_y{}, odd_x{}, odd_y{};
    const auto add = [=](std::uint32_t k, Floats & of_x, Floats & of_y) __attribute__((always_inline)) {
      Floats c, x_j, y_j;
      matrigrate::load(coefficient + lanes * k, c);
      matrigrate::load(at_x + distance[k], x_j);
      matrigrate::load(at_y + distance[k], y_j);
      of_x += c * x_j;
      of_y += c * y_j;
    };
    std::uint32_t k = first[n];
    const std::uint32_t end = k + count[n];
    for (; k + 1 < end; k += 2) {
      add(k, sum_x, sum_y);
      add(k + 1, odd_x, odd_y);
    }
    if (k < end) add(k, sum_x, sum_y);
    Floats d, x_i, y_i;
    load(D.x() + row, d);
    load(at_x, x_i);
    load(at_y, y_i);
    Floats to_x = d * x_i - (sum_x + odd_x);
    Floats to_y = d * y_i - (sum_y + odd_y);
    if (b != nullptr) {
      Floats b_x, b_y;
      load(b->x() + row, b_x);
      load(b->y() + row, b_y);
      to_x = b_x - to_x;
      to_y = b_y - to_y;
    }
    store_pack(to_x, y.x() + row);
    store_pack(to_y, y.y() + row);
  }
}

/// y = b - (D x - G x) of four rows.
[[gnu::always_inline]] inline void subtract(const Doubles& sum, const double* D, const double* b, const double* x,
                                            double* y) {
  Doubles d, of_b, of_x;
  load(D, d);
  load(b, of_b);
  load(x, of_x);
  store_pack(of_b - (d * of_x - sum), y);
}

/// y = b - (D x - G x) in double precision; D has no frame, and rows beyond `size` are left alone.
MATRIGRATE_SIMD
void residuals(std::span<const std::uint32_t> first, std::span<const std::uint32_t> count, const std::int32_t* distance,
               const float* coefficient, std::size_t block, std::size_t size, const double* D, const DoubleField& b,
               const DoubleField& x, DoubleField& y) {
  for (std::size_t n = 0; n < count.size(); ++n) {
    const std::size_t row = (block + n) * lanes;
    const double* at_x = x.x() + row;
    const double* at_y = x.y() + row;
    Doubles x_low{}, x_high{}, y_low{}, y_high{};
    for (std::uint32_t k = first[n]; k < first[n] + count[n]; ++k) {
      HalfFloats g_low, g_high;
      load(coefficient + lanes * k, g_low);
      load(coefficient + lanes * k + 4, g_high);
      Doubles low, high;
      widen(g_low, low);
      widen(g_high, high);
      Doubles x0, x1, y0, y1;
      load(at_x + distance[k], x0);
      load(at_x + distance[k] + 4, x1);
      load(at_y + distance[k], y0);
      load(at_y + distance[k] + 4, y1);
      x_low += low * x0;
      x_high += high * x1;
      y_low += low * y0;
      y_high += high * y1;
    }
    if (row + lanes <= size) {
      subtract(x_low, D + row, b.x() + row, at_x, y.x() + row);
      subtract(x_high, D + row + 4, b.x() + row + 4, at_x + 4, y.x() + row + 4);
      subtract(y_low, D + row, b.y() + row, at_y, y.y() + row);
      subtract(y_high, D + row + 4, b.y() + row + 4, at_y + 4, y.y() + row + 4);
      continue;
    }
    double sx[lanes], sy[lanes];
    store_pack(x_low, sx);
    store_pack(x_high, sx + 4);
    store_pack(y_low, sy);
    store_pack(y_high, sy + 4);
    for (std::size_t l = 0; row + l < size; ++l) {
      y.x()[row + l] = b.x()[row + l] - (D[row + l] * at_x[l] - sx[l]);
      y.y()[row + l] = b.y()[row + l] - (D[row + l] * at_y[l] - sy[l]);
    }
  }
}

} // namespace

RowPattern::RowPattern(const Adjacency& pairs, std::span<const std::uint8_t> prescribed) {
  update(pairs, prescribed, {});
}

void RowPattern::update(const Adjacency& pairs, std::span<const std::uint8_t> prescribed,
                        std::span<const std::uint8_t> changed) {
  const bool all = m_size != pairs.size();
  m_size = pairs.size();
  m_blocks.resize((m_size + lanes - 1) / lanes);
  m_meets_prescribed.resize(m_blocks.size());
  const auto is_prescribed = [prescribed](std::size_t i) { return !prescribed.empty() && prescribed[i] != 0; };
  const auto update = [&](std::size_t block, std::vector<std::int32_t>& of_row, std::vector<std::int32_t>& both) {
    const std::size_t row = lanes * block;
    const std::size_t end = std::min(m_size, row + lanes);
    if (!all && std::ranges::find(changed.subspan(row, end - row), 1) == changed.subspan(row, end - row).end()) return;
    std::vector<std::int32_t>& distances = m_blocks[block];
    distances.clear();
    bool meets = false;
    for (std::size_t i = row; i < end; ++i) {
      if (is_prescribed(i)) {
        meets = true;
        continue;
      }
      of_row.clear();
      for (const std::uint32_t j : pairs.of(i)) {
        of_row.push_back(static_cast<std::int32_t>(j) - static_cast<std::int32_t>(i));
        meets = meets || is_prescribed(j);
      }
      if (of_row == distances) continue;
      both.clear();
      std::ranges::set_union(distances, of_row, std::back_inserter(both));
      distances.assign(both.begin(), both.end());
    }
    m_meets_prescribed[block] = meets ? 1 : 0;
  };
  parallel_ranges(m_blocks.size(), 64, [&](std::size_t begin, std::size_t end) {
    std::vector<std::int32_t> of_row, both;
    for (std::size_t block = begin; block < end; ++block) update(block, of_row, both);
  });
}

void RowBlocks::fit(const RowPattern& pattern, std::span<const std::uint8_t> changed, std::span<std::uint8_t> marks) {
  constexpr std::uint32_t spare = 4; // entries a block may grow by before its part is laid out anew
  for (std::size_t p = 0; p < m_parts.size(); ++p) {
    const std::size_t begin = p * blocks_per_part;
    const std::size_t end = std::min(pattern.blocks(), begin + blocks_per_part);
    Part& part = m_parts[p];
    bool fits = !part.first.empty();
    for (std::size_t b = begin; b < end; ++b) {
      const auto rows = changed.subspan(b * lanes, std::min(m_size, (b + 1) * lanes) - b * lanes);
      if (std::ranges::find(rows, 1) == rows.end()) continue;
      marks[b] = 1;
      fits = fits && pattern.distances(b).size() <= part.first[b - begin + 1] - part.first[b - begin];
    }
    if (fits) continue;
    part.first.assign(1, 0);
    for (std::size_t b = begin; b < end; ++b) {
      part.first.push_back(part.first.back() + static_cast<std::uint32_t>(pattern.distances(b).size()) + spare);
      marks[b] = 1;
    }
    part.count.resize(end - begin);
    part.distance.resize(part.first.back());
    part.coefficient.resize(lanes * part.first.back());
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
  const auto end = begin + part.count[block % blocks_per_part];
  const auto distance = static_cast<std::int32_t>(j) - static_cast<std::int32_t>(i);
  const auto found = std::lower_bound(begin, end, distance);
  if (found == end || *found != distance) return nullptr;
  float& G = part.coefficient[lanes * static_cast<std::size_t>(found - part.distance.begin()) + i % lanes];
  return G != 0.0F ? &G : nullptr;
}

template <class Body>
void RowBlocks::each_part(const Body& body) const {
  constexpr std::size_t grain = 3; // with fewer a fork takes longer than what it divides
  parallel_for(
      m_parts.size(), [&](std::size_t p) { body(m_parts[p], p * blocks_per_part); }, grain);
}

void RowBlocks::multiply(const Field& D, const Field& x, Field& y) const {
  each_part([&](const Part& part, std::size_t block) {
    products(part.first, part.count, part.distance.data(), part.coefficient.data(), block, D, nullptr, x, y);
  });
}

void RowBlocks::residual(const Field& D, const Field& b, const Field& x, Field& y) const {
  each_part([&](const Part& part, std::size_t block) {
    products(part.first, part.count, part.distance.data(), part.coefficient.data(), block, D, &b, x, y);
  });
}

void RowBlocks::residual(std::span<const double> D, const DoubleField& b, const DoubleField& x, DoubleField& y,
                         const std::function<void(std::size_t, std::size_t)>& then) const {
  each_part([&](const Part& part, std::size_t block) {
    residuals(part.first, part.count, part.distance.data(), part.coefficient.data(), block, m_size, D.data(), b, x, y);
    if (then) then(block * lanes, std::min(m_size, (block + part.count.size()) * lanes));
  });
}

} // namespace matrigrate
