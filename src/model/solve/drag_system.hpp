#pragma once

#include "base/vector.hpp"
#include "solve/row_blocks.hpp"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

/// The linear system for the velocities that balance all forces. This folder has no physics of cells or gels.
namespace matrigrate {

/// Quadratic terms c_m |sum_k w_mk . v_k|^2 / 2 of the dissipation, each over a few nodes k: a coefficient c_m >= 0
/// [nN s/um] and weights w_mk, scalars (isotropic) or vectors (along a direction). Each term adds the positive
/// semidefinite rank-one matrix c_m w_m w_m^T (scalar weights: one per component).
template <class Weight>
struct DragTerms {
  std::vector<double> c;               ///< one per term [nN s/um]
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
/// a diagonal D for all nodes: D_ii = sum_j G_ij + own drag. The following nodes (the cell) are coupled by terms only.
/// A node with a prescribed velocity (Dirichlet condition) has D_ii = 1, its velocity as F, no coupling and no entry in
/// any term; its drag on other nodes is included in their F and D_ii. A is symmetric. It is positive definite if every
/// group of coupled nodes has a prescribed velocity or own drag.
struct DragSystem {
  RowBlocks pairs;                      ///< G_ij of the matrix [nN s/um]; 0 where either node is prescribed
  std::vector<std::uint8_t> prescribed; ///< 1 for each node of the matrix whose velocity is prescribed
  std::vector<double> diagonal;         ///< D_ii > 0, one per node, without the terms [nN s/um]
  std::vector<std::uint8_t> touched;    ///< 1 for each row of the matrix with more than the drag of its pairs
  DragTerms<double> links;              ///< isotropic terms (the same for both components)
  DragTerms<Vec2> directed;             ///< terms along a direction
  std::vector<Vec2> position;           ///< of the nodes of the matrix; needed to construct a multigrid solver [um]
  std::vector<Vec2> F;                  ///< right-hand side [nN]

  std::size_t size() const { return diagonal.size(); }
};

/// Forces on nodes, to be added in this order [nN].
class NodeForces {
public:
  void clear() { m_forces.clear(); }
  void add(std::uint32_t k, const Vec2& F) { m_forces.emplace_back(k, F); }
  void add_to(std::span<Vec2> force) const {
    for (const auto& [k, F] : m_forces) force[k] += F;
  }

private:
  std::vector<std::pair<std::uint32_t, Vec2>> m_forces;
};

/// y = A x.
void multiply(const DragSystem& A, std::span<const Vec2> x, std::span<Vec2> y);

/// Velocities or forces of all nodes: a field for the matrix, plain vectors for the cell.
struct NodeVectors {
  DoubleField matrix;
  std::vector<Vec2> cell_dofs;

  void resize(std::size_t of_matrix, std::size_t of_all);
  Vec2 operator[](std::size_t k) const {
    return k < matrix.size() ? Vec2(matrix.x()[k], matrix.y()[k]) : cell_dofs[k - matrix.size()];
  }
  void add(std::size_t k, const Vec2& a);
};

/// Converts between a plain array and NodeVectors.   @param matrix  number of nodes of the matrix
void split(std::span<const Vec2> a, std::size_t matrix, NodeVectors& b);
void join(const NodeVectors& a, std::span<Vec2> b);

/// r = F - A x for any F.
void residual(const DragSystem& A, const NodeVectors& F, const NodeVectors& x, NodeVectors& r);

/// Workspace of the next function.
struct ResidualFields {
  NodeVectors b, x, r;
};
void residual(const DragSystem& A, std::span<const Vec2> F, std::span<const Vec2> x, std::span<Vec2> r,
              ResidualFields& fields);

/// The 2x2 blocks on the diagonal of A, terms included [nN s/um].
void diagonal_blocks(const DragSystem& A, std::vector<Mat2>& blocks);

/// Outcome of a solve.
struct SolveReport {
  int iterations = 0;
  double residual = 0.0; ///< |F - A v| / |F|, 2-norm over both components [-]
  bool converged = false;
};

/// Interface of all solvers of the drag system.
class DragSolver {
public:
  virtual ~DragSolver() = default;

  /// @param A       the system
  /// @param find_F  makes A.F whole; called once, beside what needs A alone
  /// @param v       first guess in, solution out [um/s]
  virtual SolveReport solve(const DragSystem& A, const std::function<void()>& find_F, std::span<Vec2> v) = 0;

  SolveReport solve(const DragSystem& A, std::span<Vec2> v) {
    return solve(
        A, [] {}, v);
  }
};

} // namespace matrigrate
