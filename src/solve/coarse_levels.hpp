#pragma once

#include "solve/drag_system.hpp"
#include "solve/elimination.hpp"
#include "solve/grid.hpp"
#include "solve/interpolation.hpp"
#include "solve/lumped_links.hpp"
#include "solve/row_blocks.hpp"

#include <Eigen/Cholesky>

#include <vector>

namespace matrigrate {

/// Smooth velocity fields of the matrix: bilinear on square grids, each twice as coarse as the one before. Their
/// operators are the Galerkin products P^T A P of a reference system, made once, and P^T E P of the present links
/// (LumpedLinks). Fields are smooth over where the nodes were in the reference: they move with the matrix. So a
/// correction depends on the present system and on the reference alone, on no earlier step.
/// Test: tests/unit/solve/multigrid_test.cpp
class CoarseLevels {
public:
  /// @param reference  a system at rest with its positions; its terms are ignored
  /// @param spacing    of the finest grid [um], > 0
  CoarseLevels(const DragSystem& reference, double spacing);

  /// Takes the links of A; a system that has not the nodes of the reference is left without corrections.
  /// @param elimination  factorised for A
  void take_links(const DragSystem& A, const Elimination& elimination);

  /// z += P B P^T r, where B is one V-cycle on the grids, symmetric and positive definite.
  void add_correction(const Field& r, Field& z);

private:
  struct Level {
    Interpolation P;                                     ///< to the level before, of the first one to the nodes
    Grid at_links;                                       ///< its points around the linked nodes
    RowBlocks pairs;                                     ///< of the reference, beside its diagonal
    Field diagonal, inverse_diagonal, smoother, b, x, r; ///< the smoother knows the links
  };
  void cycle(std::size_t level);
  void residual(Level& level);

  bool m_fits = false;
  std::vector<Vec2> m_X; // of the nodes of the reference
  std::vector<Level> m_levels;
  Eigen::MatrixXf m_coarsest; ///< of the last level, without links
  Eigen::LLT<Eigen::MatrixXf> m_factor;
  Eigen::MatrixX2f m_b;
  LumpedLinks m_links;
  Field m_linked;
};

} // namespace matrigrate
