#pragma once

#include "base/vector.hpp"
#include "solve/row_blocks.hpp"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

/// The velocities that balance all forces. This folder knows neither cells nor gels.
namespace matrigrate {

/// A list of quadratic terms c_m |sum_k w_mk . v_k|^2 / 2 of the dissipation, each over a few nodes k: a coefficient
/// c_m >= 0 [nN s/um] and weights w_mk, scalars (both components alike) or vectors (along a direction). Each adds the
/// positive semidefinite matrix c_m w_m w_m^T.
template <class Weight>
struct DragTerms {
  std::vector<double> c;               ///< one a term [nN s/um]
  std::vector<std::uint32_t> first{0}; ///< term m has the entries first[m] .. first[m + 1] - 1
  std::vector<std::uint32_t> node;
  std::vector<Weight> weight; ///< [-]

  std::size_t size() const { return c.size(); }

  void clear() {
    c.clear();
    first.assign(1, 0);
    node.clear();
    weight.clear();
  }

  void add(double coefficient, std::initializer_list<std::pair<std::uint32_t, Weight>> entries) {
    for (const auto& [k, w] : entries) add_entry(k, w);
    close(coefficient);
  }

  /// Entry by entry, for terms over many nodes; close() ends the term.
  void add_entry(std::uint32_t k, const Weight& w) {
    node.push_back(k);
    weight.push_back(w);
  }
  void close(double coefficient) {
    c.push_back(coefficient);
    first.push_back(static_cast<std::uint32_t>(node.size()));
  }
};

/// The equation solved in every step (Heck et al. 2020, Eqs. 1-2, without inertia):
///   A v = F,   A = (D - G) (x) I_2 + sum over links and directed terms,
/// with pairwise drag coefficients G_ij = G_ji >= 0 [nN s/um] between the first pairs.size() nodes (the matrix), and
/// a diagonal D for all nodes: D_ii = sum_j G_ij + own drag. The nodes after them (those of the cell) are coupled by
/// terms alone. A node whose velocity is prescribed has the row D_ii = 1, no coupling, no place in any term, and its
/// velocity as F; its drag on others stands in their F and D_ii. A is symmetric, and positive definite as soon as each
/// group of coupled nodes has a prescribed velocity or own drag.
struct DragSystem {
  RowBlocks pairs;                      ///< G_ij of the matrix [nN s/um]; 0 where either node is prescribed
  std::vector<std::uint8_t> prescribed; ///< 1 for each node of the matrix whose velocity is prescribed
  std::vector<double> diagonal;         ///< D_ii > 0, one a node; terms not included [nN s/um]
  std::vector<std::uint8_t> touched; ///< 1 for each row of the matrix that more than the drag of its pairs was added to
  DragTerms<double> links;           ///< terms that treat both components alike
  DragTerms<Vec2> directed;          ///< terms along a direction
  std::vector<Vec2> position;        ///< of the nodes of the matrix, for solvers that are made for this system [um]
  std::vector<Vec2> F;               ///< right-hand side [nN]

  std::size_t size() const { return diagonal.size(); }
};

/// y = A x.
void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y);

/// Velocities or forces of all nodes: those of the matrix as a field, those of the cell as they are.
struct NodeVectors {
  DoubleField matrix;
  std::vector<Vec2> cell_dofs;

  void resize(std::size_t of_matrix, std::size_t of_all);
  Vec2 operator[](std::size_t k) const {
    return k < matrix.size() ? Vec2(matrix.x()[k], matrix.y()[k]) : cell_dofs[k - matrix.size()];
  }
  void add(std::size_t k, const Vec2& a);
};

/// The same numbers.   @param matrix  how many nodes come first
void split(std::span<const Vec2> a, std::size_t matrix, NodeVectors& b);
void join(const NodeVectors& a, std::span<Vec2> b);

/// r = F - A x for any F.
void residual(const DragSystem& A, const NodeVectors& F, const NodeVectors& x, NodeVectors& r);

/// Workspace of the next one.
struct ResidualFields {
  NodeVectors b, x, r;
};
void residual(const DragSystem& A, std::span<const Vec2> F, std::span<const Vec2> x, std::span<Vec2> r,
              ResidualFields& fields);

/// The 2x2 blocks on the diagonal of A, terms included [nN s/um].
void diagonal_blocks(const DragSystem& A, std::vector<Mat2>& blocks);

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
