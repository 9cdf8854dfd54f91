#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

#include <span>
#include <vector>

/// The velocities that balance all forces. This folder knows neither cells nor gels.
namespace matrigrate {

/// The equation solved in every step (Heck et al. 2020, Eqs. 1-2, without inertia):
///   A v = F,   A_ii = sum_j G_ij (+ own drag),  A_ij = -G_ij,
/// with pairwise drag coefficients G_ij = G_ji >= 0 [nN s/um]. A is scalar: both velocity components share it. A node
/// whose velocity is given has the row A_ii = 1, no coupling, and its velocity as F; its drag on others stands in their
/// F and A_ii. A is symmetric, and positive definite as soon as each group of coupled nodes has a given velocity or own
/// drag.
struct DragSystem {
  const Adjacency* pairs = nullptr; ///< the pattern; owned elsewhere
  std::vector<double> coupling;     ///< G_ij >= 0 beside pairs->index; 0 where either node is given [nN s/um]
  std::vector<double> diagonal;     ///< A_ii > 0 [nN s/um]
  std::vector<Vec2> F;              ///< right-hand sides for both components [nN]

  std::size_t size() const { return diagonal.size(); }
};

/// y = A x.
void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y);

/// How a solve went.
struct SolveReport {
  int iterations = 0;
  double residual = 0.0; ///< |F - A v| / |F|, 2-norm over both components [-]
  bool converged = false;
};

/// Anything that solves the drag system.
class DragSolver {
public:
  virtual ~DragSolver() = default;

  /// @param A  the system
  /// @param v  first guess in, solution out [um/s]
  virtual SolveReport solve(const DragSystem& A, std::span<Vec2> v) = 0;
};

} // namespace matrigrate
