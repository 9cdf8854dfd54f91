#pragma once

#include "solve/field.hpp"
#include "solve/grid.hpp"

#include <cstdint>
#include <vector>

namespace matrigrate {

/// The matrix P of a grid whose nodes stay where they are. Eight nodes in a row, and their few points between them, are
/// taken at once; weights are rounded to multiples of 2^-20, so that nodes of a lattice share theirs.
/// Test: tests/unit/solve/interpolation_test.cpp
class Interpolation {
public:
  Interpolation() = default;

  /// @param grid  located at the nodes   @param nodes  how many these are
  Interpolation(const Grid& grid, std::size_t nodes);

  /// a = P^T r.   @param r  framed, as all fields are
  void restrict_to(const Field& r, Field& a) const;

  /// z += P a.
  void interpolate(const Field& a, Field& z) const;

private:
  std::vector<std::uint32_t> m_first_point{0}, m_point; // of each block of eight nodes
  std::vector<std::uint32_t> m_weights_of;              // of each block: where its weights begin, eight a point
  std::vector<float> m_weights;                         // of all blocks that differ
  std::vector<std::uint32_t> m_first_run{0}, m_node;    // of each point: its runs of up to four nodes, from m_node on
  std::vector<float> m_run_weights;                     // four a run
};

} // namespace matrigrate
