#pragma once

#include "solve/drag_system.hpp"

#include <vector>

namespace matrigrate {

/// Conjugate gradients with the 2x2 diagonal blocks as preconditioner (Hestenes and Stiefel 1952).
/// Simple on purpose: the reference solver that faster ones are tested against. Test:
/// tests/unit/solve/solve_test.cpp
class ConjugateGradient final : public DragSolver {
public:
  /// @param tolerance       relative residual at which to stop [-], > 0
  /// @param max_iterations  maximum number of iterations
  ConjugateGradient(double tolerance, int max_iterations) : m_tolerance(tolerance), m_max_iterations(max_iterations) {}

  using DragSolver::solve;
  SolveReport solve(const DragSystem& A, const std::function<void()>& find_F, std::span<Vec2> v) override;

private:
  double m_tolerance;
  int m_max_iterations;
  std::vector<Vec2> m_r, m_z, m_p, m_q; // residual, preconditioned residual, direction, A direction
  std::vector<Mat2> m_inverse;          // of the diagonal blocks
};

} // namespace matrigrate
