#pragma once

#include "solve/drag_system.hpp"
#include "solve/grid.hpp"
#include "solve/row_blocks.hpp"

#include <Eigen/SparseCholesky>

#include <vector>

namespace matrigrate {

/// Smooth velocity fields of the matrix: bilinear on square grids, each twice as coarse as the one before. The
/// operators are the Galerkin products P^T A P of a reference system, made once; interpolation from the finest grid to
/// the nodes follows them wherever they have moved. So a correction depends on the present positions and on the
/// reference alone, on no earlier step. Test: tests/unit/solve/multigrid_test.cpp
class CoarseLevels {
public:
  /// @param reference  a system at rest with its positions; its terms are ignored
  /// @param spacing    of the finest grid [um], > 0
  CoarseLevels(const DragSystem& reference, double spacing);

  /// Follows the nodes of A.
  void locate(const DragSystem& A);

  /// z += P B P^T r, where B is one V-cycle on the grids, symmetric and positive definite.
  void add_correction(const Field& r, Field& z);

private:
  struct Level {
    Grid grid; ///< interpolates to the level before, the first one to the nodes
    RowBlocks A;
    Field smoother, b, x, r; ///< smoother: the inverse of the diagonal
  };
  void cycle(std::size_t level);

  std::vector<Level> m_levels;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<float>> m_coarsest;
  Eigen::MatrixX2f m_b;
};

/// 1 for each node of the matrix that has a coupling, 0 for those whose velocity is given.
std::vector<std::uint8_t> free_nodes(const DragSystem& A);

} // namespace matrigrate
