#pragma once

#include "base/adjacency.hpp"
#include "base/parallel.hpp"
#include "solve/field.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Who may meet whom, in blocks of eight rows: a block lists the distances (partner minus row) that occur in it.
/// Neighbours on a lattice share their distances.
class RowPattern {
public:
  RowPattern() = default;

  /// @param prescribed  1 for nodes whose velocity is prescribed, 0 for the others; empty: none. Their rows need no
  /// partners.
  explicit RowPattern(const Adjacency& pairs, std::span<const std::uint8_t> prescribed = {});

  /// After rows of the list have changed; a pattern of another size is made anew.   @param changed  1 for each that has
  void update(const Adjacency& pairs, std::span<const std::uint8_t> prescribed, std::span<const std::uint8_t> changed);

  std::size_t size() const { return m_size; } ///< rows
  std::size_t blocks() const { return m_blocks.size(); }
  std::span<const std::int32_t> distances(std::size_t block) const { return m_blocks[block]; }
  /// Whether a row of the block, or a partner, is prescribed.
  bool meets_prescribed(std::size_t block) const { return m_meets_prescribed[block] != 0; }

private:
  std::size_t m_size = 0;
  std::vector<std::vector<std::int32_t>> m_blocks; // distances of each, in ascending order
  std::vector<std::uint8_t> m_meets_prescribed;
};

/// A symmetric sparse matrix G without diagonal, in single precision, in blocks of eight rows: products run over
/// contiguous numbers. Distances at which a block has no coefficient but zeros are left out, so sums have the same bits
/// however far the pattern reaches. Test: tests/unit/solve/row_blocks_test.cpp
class RowBlocks {
public:
  static constexpr std::size_t lanes = Field::lanes;

  std::size_t size() const { return m_size; } ///< rows

  /// Fills the matrix: fill(block, distances, values) sets the coefficients of the block's eight rows, distance after
  /// distance, zero where a row has no such partner. It leaves out distances without any other, moves the ones that
  /// remain to the front, and returns their number.
  template <class Fill>
  void assign(const RowPattern& pattern, const Fill& fill);

  /// Makes room for a pattern of which rows have changed since assign(), and marks the blocks that have to be filled
  /// anew with 1.   @param changed  1 for each row that has
  void fit(const RowPattern& pattern, std::span<const std::uint8_t> changed, std::span<std::uint8_t> marks);

  /// Fills the blocks anew that are marked with 1.   @param pattern  that of assign(), or of fit() since
  template <class Fill>
  void refill(const RowPattern& pattern, std::span<const std::uint8_t> marks, const Fill& fill);

  /// From G beside pairs.index.
  void assign(const Adjacency& pairs, std::span<const double> G);

  /// The coefficient of row i and partner j, or null where there is none or it is zero.
  float* find(std::size_t i, std::size_t j);

  /// Calls visit(j, G_ij) for all coefficients of row i but zeros.
  template <class Visit>
  void each_of_row(std::size_t i, const Visit& visit) const;

  /// y = D x - G x.   @param D  in its x components, framed as x
  void multiply(const Field& D, const Field& x, Field& y) const;

  /// y = b - (D x - G x).
  void residual(const Field& D, const Field& b, const Field& x, Field& y) const;

  /// The same in double precision, where D is one a row.
  void residual(std::span<const double> D, const DoubleField& b, const DoubleField& x, DoubleField& y) const;

private:
  static constexpr std::size_t blocks_per_part = 64;

  /// Some consecutive blocks, built and multiplied by one thread.
  struct Part {
    std::vector<std::uint32_t> first, count; // entries of block b: count[b] of them from first[b] on, of a room
                                             // that ends at first[b + 1]
    std::vector<std::int32_t> distance;
    std::vector<float> coefficient; // eight an entry
  };
  template <class Body>
  void each_part(const Body& body) const;

  std::size_t m_size = 0;
  std::vector<Part> m_parts;
};

template <class Fill>
void RowBlocks::assign(const RowPattern& pattern, const Fill& fill) {
  std::vector<std::uint8_t> marks(pattern.blocks());
  m_size = pattern.size();
  m_parts.resize((pattern.blocks() + blocks_per_part - 1) / blocks_per_part);
  fit(pattern, std::vector<std::uint8_t>(m_size, 1), marks);
  refill(pattern, marks, fill);
}

template <class Fill>
void RowBlocks::refill(const RowPattern& pattern, std::span<const std::uint8_t> marks, const Fill& fill) {
  parallel_parts(m_parts.size(), [&](std::size_t p) {
    Part& part = m_parts[p];
    for (std::size_t b = 0; b < part.count.size(); ++b) {
      const std::size_t block = p * blocks_per_part + b;
      if (marks[block] == 0) continue;
      const std::span<std::int32_t> distances(part.distance.data() + part.first[b], pattern.distances(block).size());
      std::ranges::copy(pattern.distances(block), distances.begin());
      part.count[b] =
          static_cast<std::uint32_t>(fill(block, distances, part.coefficient.data() + lanes * part.first[b]));
    }
  });
}

template <class Visit>
void RowBlocks::each_of_row(std::size_t i, const Visit& visit) const {
  const std::size_t block = i / lanes;
  const Part& part = m_parts[block / blocks_per_part];
  const std::size_t b = block % blocks_per_part;
  for (std::uint32_t k = part.first[b]; k < part.first[b] + part.count[b]; ++k)
    if (const float G = part.coefficient[lanes * k + i % lanes]; G != 0.0F)
      visit(static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + part.distance[k]), G);
}

} // namespace matrigrate
