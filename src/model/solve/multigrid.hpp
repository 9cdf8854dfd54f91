#pragma once

#include "solve/coarse_levels.hpp"
#include "solve/drag_system.hpp"
#include "solve/elimination.hpp"
#include "solve/field.hpp"

#include <vector>

namespace matrigrate {

/// Conjugate gradients, preconditioned by one V-cycle of geometric multigrid (Brandt 1977), on the matrix alone: the
/// degrees of freedom of the cell are eliminated (Schur complement). Mixed precision: corrections in single, residuals
/// in double. If a single-precision correction reduces the residual by at most 1e4, the residual of the CG recurrence
/// is used instead of one recomputed in double precision (they agree within 2 %). A solve depends on the reference, A
/// and the first guess only, not on earlier solves, and has the same bits for any number of threads. Test:
/// tests/unit/solve/multigrid_test.cpp
class Multigrid final : public DragSolver {
public:
  /// @param reference       the undeformed system with its positions; its terms are ignored
  /// @param spacing         of the particles [um], > 0
  /// @param tolerance       relative residual at which to stop [-], > 0
  /// @param max_iterations  maximum number of iterations
  Multigrid(const DragSystem& reference, double spacing, double tolerance, int max_iterations)
      : m_tolerance(tolerance), m_max_iterations(max_iterations), m_coarse(reference, 2.0 * spacing) {}

  using DragSolver::solve;
  SolveReport solve(const DragSystem& A, const std::function<void()>& find_F, std::span<Vec2> v) override;

private:
  void prepare(const DragSystem& A);
  double residual(const DragSystem& A);
  double correct(double r, double reduction, SolveReport& report);
  void multiply(const Field& x, Field& y);
  void residual_after(const Field& x, Field& y);
  double precondition();

  double m_tolerance;
  int m_max_iterations;
  CoarseLevels m_coarse;
  Elimination m_elimination;
  const RowBlocks* m_pairs = nullptr; ///< of the system that is solved
  NodeVectors m_F, m_v, m_residual;
  std::vector<Vec2> m_cell_dofs; ///< correction of the nodes of the cell
  Field m_diagonal, m_smoother, m_x, m_r, m_z, m_p,
      m_q; // of the correction: solution, residual, preconditioned residual, search direction, matrix times direction
};

} // namespace matrigrate
