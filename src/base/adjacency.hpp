#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// For each particle i the particles j != i that it meets, in ascending order (compressed rows). A list is symmetric: j
/// is listed by i exactly if i is listed by j. Data of the pair (i, j) is kept in arrays that run beside `index`.
struct Adjacency {
  std::vector<std::uint32_t> first; ///< row i is index[first[i]] .. index[first[i + 1] - 1]; n + 1 entries
  std::vector<std::uint32_t> index;
  std::vector<std::uint32_t> mirror; ///< entry of (j, i) for each entry (i, j); from pair_up()

  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
  std::size_t pairs() const { return index.size(); }
  /// First entry (i, j) of row i with j > i.
  std::uint32_t upper(std::size_t i) const {
    const auto row = of(i);
    return first[i] + static_cast<std::uint32_t>(std::upper_bound(row.begin(), row.end(), i) - row.begin());
  }
  std::span<const std::uint32_t> of(std::size_t i) const {
    return {index.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
  }
};

/// Finds the mirror of every entry. Rows are ascending and the list is symmetric, so row j meets its partners i in the
/// order of i.
inline void pair_up(Adjacency& a) {
  a.mirror.resize(a.index.size());
  std::vector<std::uint32_t> next(a.first.begin(), a.first.end());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::uint32_t k = a.first[i]; k < a.first[i + 1]; ++k) a.mirror[k] = next[a.index[k]]++;
}

} // namespace matrigrate
