#include "solve/row_blocks.hpp"

#include <array>
#include <limits>

namespace matrigrate {

namespace {

constexpr std::size_t lanes = Field::lanes;

using Four = Eigen::Array4f;
using FourAt = Eigen::Map<const Eigen::Array4f>;

/// Whether the rows first[0..] all list the same distances.
bool alike(const Adjacency& pairs, std::size_t row) {
  const std::uint32_t* start = pairs.first.data() + row;
  const std::uint32_t count = start[1] - start[0];
  for (std::uint32_t l = 1; l < lanes; ++l) {
    if (start[l + 1] - start[l] != count) return false;
    const std::uint32_t* a = pairs.index.data() + start[0];
    const std::uint32_t* b = pairs.index.data() + start[l];
    std::uint32_t difference = 0;
    for (std::uint32_t k = 0; k < count; ++k) difference |= (b[k] - l) ^ a[k];
    if (difference != 0) return false;
  }
  return true;
}

} // namespace

struct RowBlocks::Source {
  const Adjacency& pairs;
  std::span<const double> G, D;
};

void RowBlocks::append_block(const Source& source, std::size_t row, Part& part) {
  const Adjacency& pairs = source.pairs;
  const std::size_t count = std::min(lanes, pairs.size() - row);
  const auto append = [&part](std::int32_t distance, const std::array<float, lanes>& values) {
    part.coefficient.resize(lanes * (part.distance.size() + 1));
    std::ranges::copy(values, part.coefficient.end() - lanes);
    part.distance.push_back(distance);
  };
  std::array<float, lanes> values{};
  for (std::size_t l = 0; l < count; ++l) values[l] = static_cast<float>(source.D[row + l]);
  append(0, values);

  const std::uint32_t* first = pairs.first.data() + row;
  if (count == lanes && alike(pairs, row)) {
    for (std::uint32_t k = 0; k < first[1] - first[0]; ++k) {
      bool any = false;
      for (std::size_t l = 0; l < lanes; ++l) {
        const double g = source.G[first[l] + k];
        any = any || g != 0.0;
        values[l] = static_cast<float>(-g);
      }
      if (any) append(static_cast<std::int32_t>(pairs.index[first[0] + k]) - static_cast<std::int32_t>(row), values);
    }
    return;
  }
  constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();
  std::array<std::uint32_t, lanes> next{}; // entry of each row that comes next
  std::array<std::int32_t, lanes> distance{};
  const auto advance = [&](std::size_t l) {
    while (next[l] < first[l + 1] && source.G[next[l]] == 0.0) ++next[l];
    distance[l] = next[l] < first[l + 1]
                      ? static_cast<std::int32_t>(pairs.index[next[l]]) - static_cast<std::int32_t>(row + l)
                      : none;
  };
  distance.fill(none);
  for (std::size_t l = 0; l < count; ++l) {
    next[l] = first[l];
    advance(l);
  }
  for (;;) {
    const std::int32_t least = *std::min_element(distance.begin(), distance.end());
    if (least == none) return;
    values.fill(0.0F);
    for (std::size_t l = 0; l < count; ++l) {
      if (distance[l] != least) continue;
      values[l] = static_cast<float>(-source.G[next[l]++]);
      advance(l);
    }
    append(least, values);
  }
}

void RowBlocks::assign(const Adjacency& pairs, std::span<const double> G, std::span<const double> D) {
  const std::size_t blocks = (pairs.size() + lanes - 1) / lanes;
  m_parts.resize((blocks + blocks_per_part - 1) / blocks_per_part);
  const Source source{pairs, G, D};
  tbb::parallel_for(std::size_t{0}, m_parts.size(), [&](std::size_t p) {
    Part& part = m_parts[p];
    part.first.assign(1, 0);
    part.distance.clear();
    part.coefficient.clear();
    for (std::size_t b = p * blocks_per_part; b < std::min(blocks, (p + 1) * blocks_per_part); ++b) {
      append_block(source, b * lanes, part);
      part.first.push_back(static_cast<std::uint32_t>(part.distance.size()));
    }
  });
}

void RowBlocks::product(const Field& x, const Field* b, Field& y) const {
  tbb::parallel_for(std::size_t{0}, m_parts.size(), [&](std::size_t p) {
    const Part& part = m_parts[p];
    for (std::size_t block = 0; block + 1 < part.first.size(); ++block) {
      const auto row = static_cast<std::ptrdiff_t>((p * blocks_per_part + block) * lanes);
      const float* at_x = x.x() + row;
      const float* at_y = x.y() + row;
      Four x0 = Four::Zero(), x1 = Four::Zero(), y0 = Four::Zero(), y1 = Four::Zero();
      for (std::uint32_t k = part.first[block]; k < part.first[block + 1]; ++k) {
        const std::ptrdiff_t d = part.distance[k];
        const FourAt c0(part.coefficient.data() + lanes * k), c1(part.coefficient.data() + lanes * k + 4);
        x0 += c0 * FourAt(at_x + d);
        x1 += c1 * FourAt(at_x + d + 4);
        y0 += c0 * FourAt(at_y + d);
        y1 += c1 * FourAt(at_y + d + 4);
      }
      if (b != nullptr) {
        x0 = FourAt(b->x() + row) - x0;
        x1 = FourAt(b->x() + row + 4) - x1;
        y0 = FourAt(b->y() + row) - y0;
        y1 = FourAt(b->y() + row + 4) - y1;
      }
      Eigen::Map<Four>(y.x() + row) = x0;
      Eigen::Map<Four>(y.x() + row + 4) = x1;
      Eigen::Map<Four>(y.y() + row) = y0;
      Eigen::Map<Four>(y.y() + row + 4) = y1;
    }
  });
}

} // namespace matrigrate
