#pragma once

#include "solve/field.hpp"
#include "solve/grid.hpp"

#include <cstdint>
#include <vector>

namespace matrigrate {

/// The matrix P of a grid whose nodes stay where they are, with its transpose by rows. Test:
/// tests/unit/solve/multigrid_test.cpp
class Interpolation {
public:
  Interpolation() = default;

  /// @param grid  located at the nodes   @param nodes  how many these are
  Interpolation(const Grid& grid, std::size_t nodes);

  /// a = P^T r.
  void restrict_to(const Field& r, Field& a) const;

  /// z += P a.
  void interpolate(const Field& a, Field& z) const;

private:
  Grid m_grid;
  std::vector<std::uint32_t> m_first, m_node; // of the points: node e of point q for m_first[q] <= e < m_first[q + 1]
  std::vector<float> m_weight;                // beside m_node, never 0
};

} // namespace matrigrate
