#pragma once

#include "base/adjacency.hpp"
#include "base/parallel.hpp"
#include "solve/field.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace matrigrate {

/// Sparsity pattern in blocks of eight rows: a block lists the index distances (column minus row) that occur in it.
/// On a lattice, adjacent rows share their distances (stencil).
class RowPattern {
public:
  RowPattern() = default;

  /// @param prescribed  1 for nodes with a prescribed velocity, 0 for the others; empty: none. Their rows need no
  /// entries.
  explicit RowPattern(const Adjacency& pairs, std::span<const std::uint8_t> prescribed = {});

  /// Updates the rows of the list that have changed; rebuilds a pattern of another size.   @param changed  1 per such
  /// row
  void update(const Adjacency& pairs, std::span<const std::uint8_t> prescribed, std::span<const std::uint8_t> changed);

  std::size_t size() const { return m_size; } ///< rows
  std::size_t blocks() const { return m_blocks.size(); }
  std::span<const std::int32_t> distances(std::size_t block) const { return m_blocks[block]; }
  /// Whether a row or a column of the block has a prescribed velocity.
  bool meets_prescribed(std::size_t block) const { return m_meets_prescribed[block] != 0; }

private:
  std::size_t m_size = 0;
  std::vector<std::vector<std::int32_t>> m_blocks; // distances of each, in ascending order
  std::vector<std::uint8_t> m_meets_prescribed;
};

/// A symmetric sparse matrix G without diagonal, in single precision, in blocks of eight rows: products use contiguous
/// SIMD loads. A block omits distances at which all its coefficients are zero, so sums have the same bits for any
/// larger pattern. Test: tests/unit/solve/solve_test.cpp
class RowBlocks {
public:
  static constexpr std::size_t lanes = Field::lanes;

  std::size_t size() const { return m_size; } ///< rows

  /// Fills the matrix. fill(block, distances, values) sets the coefficients of the block's eight rows, distance by
  /// distance, with zeros for missing entries. It removes distances with zeros only, moves the remaining ones to the
  /// front, and returns their number.
  template <class Fill>
  void assign(const RowPattern& pattern, const Fill& fill);

  /// Adapts the storage to a pattern with rows that have changed since assign(), and marks the blocks to refill with 1.
  /// @param changed  1 for each changed row
  void fit(const RowPattern& pattern, std::span<const std::uint8_t> changed, std::span<std::uint8_t> marks);

  /// Refills the blocks that are marked with 1.   @param pattern  that of assign(), or of the last fit()
  template <class Fill>
  void refill(const RowPattern& pattern, std::span<const std::uint8_t> marks, const Fill& fill);

  /// Fills the matrix from coefficients G in the order of pairs.index.
  void assign(const Adjacency& pairs, std::span<const double> G);

  /// The coefficient of row i and column j; null if it is missing or zero.
  float* find(std::size_t i, std::size_t j);

  /// Calls visit(j, G_ij) for all nonzero coefficients of row i.
  template <class Visit>
  void each_of_row(std::size_t i, const Visit& visit) const;

  /// y = D x - G x.   @param D  in its x components, padded as x
  void multiply(const Field& D, const Field& x, Field& y) const;

  /// y = b - (D x - G x).
  void residual(const Field& D, const Field& b, const Field& x, Field& y) const;

  /// The same in double precision, with one D per row.
  /// @param then  called with ranges of rows that make up all, once their y is known
  void residual(std::span<const double> D, const DoubleField& b, const DoubleField& x, DoubleField& y,
                const std::function<void(std::size_t begin, std::size_t end)>& then = {}) const;

private:
  static constexpr std::size_t blocks_per_part = 64;

  /// Consecutive blocks, built and multiplied by one thread.
  struct Part {
    std::vector<std::uint32_t> first, count; // entries of block b: count[b], starting at first[b]; its
                                             // capacity ends at first[b + 1]
    std::vector<std::int32_t> distance;
    std::vector<float> coefficient; // eight per entry
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
