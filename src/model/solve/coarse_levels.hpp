#pragma once

#include "solve/drag_system.hpp"
#include "solve/elimination.hpp"
#include "solve/field.hpp"
#include "solve/grid.hpp"
#include "solve/lumped_links.hpp"
#include "solve/row_blocks.hpp"

#include <Eigen/Cholesky>

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

/// Coarse levels of the geometric multigrid preconditioner: bilinear velocity fields of the matrix on square grids,
/// each twice as coarse as the previous one. Their operators are the Galerkin products P^T A P of a reference system,
/// computed once, and P^T E P of the current links (LumpedLinks). Grids live in the reference configuration, so their
/// fields move with the matrix. A correction depends on the current system and the reference only, not on earlier
/// steps. Test: tests/unit/solve/multigrid_test.cpp
class CoarseLevels {
public:
  /// @param reference  the undeformed system with its positions; its terms are ignored
  /// @param spacing    of the finest grid [um], > 0
  CoarseLevels(const DragSystem& reference, double spacing);

  /// Adopts the links of A. If A has other nodes than the reference, there are no coarse corrections.
  /// @param elimination  factorised for A
  void take_links(const DragSystem& A, const Elimination& elimination);

  /// z += P B P^T r, where B is one V-cycle on the grids, symmetric and positive definite.
  void add_correction(const Field& r, Field& z);

private:
  struct Level {
    Interpolation P; ///< prolongation to the next finer level; of the first level: to the nodes
    Grid at_nodes;   ///< this level's points around the nodes of the matrix
    Grid at_links;   ///< the same around the linked nodes
    RowBlocks pairs; ///< off-diagonal part of the reference operator
    Field diagonal, inverse_diagonal, smoother, b, x, r; ///< the smoother includes the links
  };
  void cycle(std::size_t level);
  void residual(Level& level);

  bool m_fits = false;
  std::size_t m_nodes = 0; // of the reference
  std::vector<Level> m_levels;
  Eigen::MatrixXf m_coarsest, m_with_links; ///< of the last level, without and with links
  Eigen::LLT<Eigen::MatrixXf> m_factor;
  Eigen::MatrixX2f m_b;
  LumpedLinks m_links;
  Field m_linked;
};

} // namespace matrigrate
