#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace matrigrate {

/// For each particle i the particles j != i that it meets, in ascending order (compressed rows). A list is symmetric: j
/// is listed by i exactly if i is listed by j. Data of the pair (i, j) is kept in arrays that run beside `index`.
struct Adjacency {
  std::vector<std::uint32_t> first; ///< row i is index[first[i]] .. index[first[i + 1] - 1]; n + 1 entries
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> count; ///< where rows have room to grow: how much of each is used; empty: all of it

  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
  std::size_t pairs() const {
    return count.empty() ? index.size() : std::accumulate(count.begin(), count.end(), std::size_t{0});
  }
  std::span<const std::uint32_t> of(std::size_t i) const {
    return {index.data() + first[i], static_cast<std::size_t>(count.empty() ? first[i + 1] - first[i] : count[i])};
  }
};

} // namespace matrigrate
