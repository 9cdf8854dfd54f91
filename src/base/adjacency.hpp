#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace matrigrate {

/// Neighbour list in compressed rows: for each particle i its neighbours j != i, in ascending order. The list is
/// symmetric: it contains (i, j) if and only if it contains (j, i). Pair data is stored in arrays parallel to `index`.
struct Adjacency {
  std::vector<std::uint32_t> first; ///< row i is index[first[i]] .. index[first[i + 1] - 1]; n + 1 entries
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> count; ///< used entries of each row, if rows have spare capacity; empty: all entries

  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
  std::size_t pairs() const {
    return count.empty() ? index.size() : std::accumulate(count.begin(), count.end(), std::size_t{0});
  }
  std::span<const std::uint32_t> of(std::size_t i) const {
    return {index.data() + first[i], static_cast<std::size_t>(count.empty() ? first[i + 1] - first[i] : count[i])};
  }
};

} // namespace matrigrate
