#pragma once

#include "solve/coarse_grid.hpp"
#include "solve/drag_system.hpp"
#include "solve/patch.hpp"

#include <vector>

namespace matrigrate {

/// Conjugate gradients with an additive two-level preconditioner: smooth fields on a CoarseGrid, the surroundings of
/// the cell on a Patch, and the diagonal elsewhere. Keeps nothing from one solve to the next.
/// Test: tests/unit/solve/two_level_test.cpp
class TwoLevel final : public DragSolver {
public:
  /// @param reference       the system at rest with its positions, without terms
  /// @param spacing         of the coarse grid [um]; about three particle spacings
  /// @param tolerance       relative residual at which to stop [-], > 0
  /// @param max_iterations  after which to give up
  TwoLevel(const DragSystem& reference, double spacing, double tolerance, int max_iterations)
      : m_tolerance(tolerance), m_max_iterations(max_iterations), m_coarse(reference, spacing) {}

  SolveReport solve(const DragSystem& A, std::span<Vec2> v) override;

private:
  void precondition(std::span<const Vec2> r);

  double m_tolerance;
  int m_max_iterations;
  CoarseGrid m_coarse;
  Patch m_patch;
  std::vector<double> m_diagonal;
  std::vector<Vec2> m_r, m_z, m_p, m_q;
};

} // namespace matrigrate
