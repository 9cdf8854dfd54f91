#pragma once

#include "base/adjacency.hpp"
#include "solve/field.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// A sparse matrix D - G in single precision whose rows are kept in blocks of eight: a block lists the distances
/// (column minus row) that occur in it, with eight coefficients each. Neighbours on a lattice share their distances, so
/// products run over contiguous numbers. Independent of zeros in G. Test: tests/unit/solve/row_blocks_test.cpp
class RowBlocks {
public:
  /// @param G  beside pairs.index   @param D  one a row
  void assign(const Adjacency& pairs, std::span<const double> G, std::span<const double> D);

  /// y = (D - G) x.
  void multiply(const Field& x, Field& y) const { product(x, nullptr, y); }

  /// y = b - (D - G) x.
  void residual(const Field& b, const Field& x, Field& y) const { product(x, &b, y); }

private:
  static constexpr std::size_t blocks_per_part = 64;

  /// Some consecutive blocks, built and multiplied by one thread.
  struct Part {
    std::vector<std::uint32_t> first; // entries of block b: first[b] .. first[b + 1] - 1
    std::vector<std::int32_t> distance;
    std::vector<float> coefficient; // eight an entry
  };
  struct Source;

  static void append_block(const Source& source, std::size_t row, Part& part);
  void product(const Field& x, const Field* b, Field& y) const;

  std::vector<Part> m_parts;
};

} // namespace matrigrate
