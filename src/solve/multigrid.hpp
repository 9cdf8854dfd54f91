#pragma once

#include "solve/coarse_levels.hpp"
#include "solve/drag_system.hpp"
#include "solve/elimination.hpp"
#include "solve/field.hpp"

#include <vector>

namespace matrigrate {

/// Conjugate gradients preconditioned by one V-cycle of geometric multigrid (Brandt 1977), for the matrix alone: the
/// nodes behind it are eliminated. Corrections are computed in single precision, residuals in double. Where a
/// correction takes the residual down by no more than 1e4, its own account of it is believed (it is within 2 % then).
/// Keeps nothing from one solve to the next: a solve depends on the reference, A and the first guess alone, and has the
/// same bits for any number of threads. Test: tests/unit/solve/multigrid_test.cpp
class Multigrid final : public DragSolver {
public:
  /// @param reference       the system at rest with its positions; its terms are ignored
  /// @param spacing         of the particles [um], > 0
  /// @param tolerance       relative residual at which to stop [-], > 0
  /// @param max_iterations  after which to give up
  Multigrid(const DragSystem& reference, double spacing, double tolerance, int max_iterations)
      : m_tolerance(tolerance), m_max_iterations(max_iterations), m_coarse(reference, 2.0 * spacing) {}

  SolveReport solve(const DragSystem& A, std::span<Vec2> v) override;

private:
  void prepare(const DragSystem& A);
  double residual(const DragSystem& A);
  double correct(double r, double reduction, SolveReport& report);
  void multiply(const Field& x, Field& y);
  void residual_after(const Field& x, Field& y);
  void precondition();

  double m_tolerance;
  int m_max_iterations;
  CoarseLevels m_coarse;
  Elimination m_elimination;
  const RowBlocks* m_pairs = nullptr; ///< of the system that is solved
  NodeVectors m_F, m_v, m_residual;
  std::vector<Vec2> m_behind; ///< correction of the nodes behind the matrix
  Field m_diagonal, m_smoother, m_x, m_r, m_z, m_p,
      m_q; // of the correction: solution, residual, the same preconditioned, direction
};

} // namespace matrigrate
