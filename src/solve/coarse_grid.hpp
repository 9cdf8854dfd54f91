#pragma once

#include "solve/drag_system.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Smooth velocity fields: bilinear on a square grid far coarser than the particles. The operator on the grid is the
/// Galerkin product P^T A P of a reference system, factorised once; P follows the nodes wherever they have moved. So a
/// correction depends on the present positions and the reference alone, on no earlier step.
/// Test: tests/unit/solve/two_level_test.cpp
class CoarseGrid {
public:
  /// @param reference  a system at rest with its positions, without terms   @param spacing  of the grid [um], > 0
  CoarseGrid(const DragSystem& reference, double spacing);

  /// Weights of all nodes of A at their present positions; nodes whose velocity is given, or that are held by far
  /// more drag than a particle, have none.
  void locate(const DragSystem& A);

  /// z += P (P^T A_reference P)^-1 P^T r.
  void add_correction(std::span<const Vec2> r, std::span<Vec2> z);

private:
  /// Where a node stands: the lower left corner of its grid cell, and the way across it. Given nodes stand in a cell of
  /// their own that carries nothing.
  struct Place {
    std::uint32_t corner = 0;
    double s = 0.0, t = 0.0; ///< in [0, 1]
  };
  /// Values at the corners of a cell: lower left, lower right, upper left, upper right.
  using Corners = std::array<Vec2, 4>;

  bool is_pinned(const DragSystem& A, std::size_t i) const { return A.diagonal[i] > m_most_drag; }
  Place place(const Vec2& x) const;
  std::array<std::size_t, 4> corners(const Place& at) const;
  void restrict_to_grid(std::span<const Vec2> r);

  double m_spacing;
  double m_most_drag = 0.0; // [nN s/um]
  Vec2 m_low;
  std::size_t m_columns = 0, m_rows = 0;
  std::vector<std::int32_t> m_unknown; // of a grid point; -1 where it carries none
  std::vector<Place> m_places;         // of the nodes
  std::vector<Vec2> m_grid;            // values at the grid points, and those of the empty cell
  Eigen::SparseMatrix<double> m_L;     // Cholesky factor of the operator; unknowns are in its order
  std::vector<Vec2> m_r;
};

/// Whether the velocity of node i is given: it has neither couplings nor terms.
bool is_given(const DragSystem& A, std::size_t i);

} // namespace matrigrate
