#pragma once

#include "solve/drag_system.hpp"
#include "solve/field.hpp"
#include "solve/lumped_links.hpp"

#include <Eigen/SparseCholesky>

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Schur complement on the matrix: the degrees of freedom of the cell are eliminated exactly. With m for the matrix and
/// c for the cell,
///   S = A_mm - A_mc A_cc^-1 A_cm,   S v_m = F_m - A_mc A_cc^-1 F_c,   v_c = A_cc^-1 (F_c - A_cm v_m).
/// S differs from the pair drag of the matrix at few nodes only, by at most the diagonal of the terms there. So the
/// stiffness of the cell does not degrade the conditioning of S. Terms over very many nodes are treated as rank-one
/// updates of A_cc (Sherman and Morrison 1950). Test: tests/unit/solve/solve_test.cpp
class Elimination {
public:
  /// Sorts the terms of A and factorises A_cc.
  void factorise(const DragSystem& A);

  /// Sets `diagonal`, in its x components, to the part of the diagonal of A_mm that comes from D and the links
  /// [nN s/um], and both components of `smoother` to 1 / an upper bound, per row, of that plus the contribution of all
  /// other terms.   @param A  as factorised
  void diagonals(const DragSystem& A, Field& diagonal, Field& smoother);

  /// The links as seen by smooth fields, for the coarse grids.
  void lump(const DragSystem& A, LumpedLinks& links) const;

  /// Computes (S - D + G) x, with D from diagonals(), up to what add_product() does.
  void multiply(const Field& x);

  /// y += factor times the product of multiply().
  void add_product(float factor, Field& y);

  /// Reduces a right-hand side r of A to that of S, in its matrix part: r_m := r_m - A_mc A_cc^-1 r_c.
  void reduce(NodeVectors& r);

  /// v_c := A_cc^-1 (r_c - A_cm v_m).   @param v_c  of the nodes of the cell
  void recover(std::span<const Vec2> r_c, const Field& v_m, std::span<Vec2> v_c);

private:
  /// A 2x2 block of A_cc at or below the diagonal.
  struct Block {
    std::uint32_t column;
    Mat2 value;
  };
  /// All links of a matrix node: its coupling with node a of the cell is the drag -(A_mc)_a.
  struct Linked {
    std::uint32_t node;
    double diagonal;            ///< of A_mm, without terms that are not links
    std::uint32_t first, count; ///< of its drags in m_drags
  };
  using Drag = std::pair<std::uint32_t, double>; ///< a and the drag
  /// A rank-one update c w w^T of A_cc: w, A_cc^-1 w without the update, and c / (1 + c w . A_cc^-1 w).
  struct Update {
    Eigen::VectorXd w, solved;
    double factor;
  };

  std::uint32_t cell_dof(std::uint32_t node) const { return node - static_cast<std::uint32_t>(m_matrix); }
  void place_links(const DragSystem& A);
  void add_link(const DragTerms<double>& terms, std::size_t m);
  void add_term(double c, std::span<const std::uint32_t> node, std::span<const Vec2> weight);
  Mat2& block(std::uint32_t a, std::uint32_t b);
  bool is_link(std::span<const std::uint32_t> node) const;
  std::span<const Drag> drags(const Linked& linked) const { return {m_drags.data() + linked.first, linked.count}; }
  void factorise_cell();
  void solve_cell();
  template <class At>
  void gather(const At& at);
  template <class Add>
  void scatter(const Add& add);

  std::size_t m_matrix = 0, m_cell_dofs = 0; // numbers of nodes
  std::vector<std::vector<Block>> m_rows;    // of A_cc
  std::vector<Linked> m_linked;
  std::vector<Drag> m_drags;             // of all of m_linked
  std::vector<std::int32_t> m_linked_of; // matrix node -> place in m_linked, or -1
  std::vector<double> m_bound;           // workspace of diagonals()
  DragTerms<Vec2> m_mixed;               // terms that are not links and have entries in the matrix
  std::vector<double> m_sums;            // of m_mixed, over its matrix nodes
  std::vector<Update> m_updates;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper> m_factor;
  Eigen::SparseMatrix<double> m_pattern; // sparsity pattern of A_cc for which m_factor was analysed
  Eigen::SparseMatrix<double> m_next;    // workspace of factorise_cell()
  Eigen::VectorXd m_t, m_solved;         // nodes of the cell, x and y interleaved; workspace of solve_cell()
};

} // namespace matrigrate
