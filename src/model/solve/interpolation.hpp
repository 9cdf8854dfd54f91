#pragma once

#include "solve/field.hpp"
#include "solve/grid.hpp"

#include <cstdint>
#include <vector>

namespace matrigrate {

/// The prolongation matrix P of a grid with fixed nodes, in blocks: eight consecutive nodes and their grid points are
/// processed together. Weights are rounded to multiples of 2^-20, so that blocks of a lattice share them.
/// Test: tests/unit/solve/solve_test.cpp
class Interpolation {
public:
  Interpolation() = default;

  /// @param grid  located at the nodes   @param nodes  number of nodes
  Interpolation(const Grid& grid, std::size_t nodes);

  /// a = P^T r.   @param r  padded, as all fields are
  void restrict_to(const Field& r, Field& a) const;

  /// z += P a.
  void interpolate(const Field& a, Field& z) const;

private:
  std::vector<std::uint32_t> m_first_point{0}, m_point; // of each block of eight nodes
  std::vector<std::uint32_t> m_weights_of;              // of each block: offset of its weights, eight per point
  std::vector<float> m_weights;                         // of all distinct blocks
  std::vector<std::uint32_t> m_first_run{0}, m_node;    // of each point: its runs of up to four nodes, from m_node on
  std::vector<float> m_run_weights;                     // four per run
};

} // namespace matrigrate
