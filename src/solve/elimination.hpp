#pragma once

#include "solve/drag_system.hpp"
#include "solve/field.hpp"
#include "solve/lumped_links.hpp"

#include <Eigen/SparseCholesky>

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// Schur complement on the matrix: the degrees of freedom of the cell are eliminated exactly. With m the matrix and c
/// the cell,
///   S = A_mm - A_mc A_cc^-1 A_cm,   S v_m = F_m - A_mc A_cc^-1 F_c,   v_c = A_cc^-1 (F_c - A_cm v_m).
/// S differs from the pair drag of the matrix at few nodes, and by no more than the diagonal of the terms there:
/// however stiff the cell is, a solver of S does not notice. Terms over very many nodes count as updates of rank one of
/// A_cc (Sherman and Morrison 1950). Test: tests/unit/solve/elimination_test.cpp
class Elimination {
public:
  /// Sorts the terms of A and factorises A_cc.
  void factorise(const DragSystem& A);

  /// D and the links' share of the diagonal of A_mm [nN s/um].
  std::span<const double> diagonal() const { return m_diagonal; }

  /// For each row of A_mm a bound from above of diagonal() and what all other terms can add [nN s/um].
  std::span<const double> bound() const { return m_bound; }

  /// The links for smooth fields.   @param X  where these see the nodes of the matrix [um]
  void lump(const DragSystem& A, std::span<const Vec2> X, LumpedLinks& links) const;

  /// y += factor (S - diagonal() + G) x.
  void add_product(float factor, const Field& x, Field& y);

  /// From a right-hand side r of A that of S, in part m: r_m := r_m - A_mc A_cc^-1 r_c.
  void reduce(NodeVectors& r);

  /// v_c := A_cc^-1 (r_c - A_cm v_m).   @param v_c  of the nodes of the cell
  void recover(std::span<const Vec2> r_c, const Field& v_m, std::span<Vec2> v_c);

private:
  /// A 2x2 block of A_cc at or below the diagonal.
  struct Block {
    std::uint32_t column;
    Mat2 value;
  };
  /// All links of a matrix node: it meets node k of the cell with the drag -(A_mc)_k.
  struct Linked {
    std::uint32_t node;
    std::vector<std::pair<std::uint32_t, double>> drag;
  };
  /// A term c w w^T of A_cc kept apart: w, A_cc^-1 w without it, and c / (1 + c w . A_cc^-1 w).
  struct Update {
    Eigen::VectorXd w, solved;
    double factor;
  };

  std::uint32_t cell_dof(std::uint32_t node) const { return node - static_cast<std::uint32_t>(m_matrix); }
  void add_link(const DragTerms<double>& terms, std::size_t m);
  void add_term(double c, std::span<const std::uint32_t> node, std::span<const Vec2> weight);
  Mat2& block(std::uint32_t a, std::uint32_t b);
  void set_bound();
  void factorise_cell();
  void solve_cell();
  template <class At>
  void gather(const At& at);
  template <class Add>
  void scatter(const Add& add);

  std::size_t m_matrix = 0, m_cell_dofs = 0; // numbers of nodes
  std::vector<double> m_diagonal, m_bound;
  std::vector<std::vector<Block>> m_rows; // of A_cc
  std::vector<Linked> m_linked;
  std::vector<std::int32_t> m_linked_of; // matrix node -> place in m_linked, or -1
  DragTerms<Vec2> m_mixed;               // terms that are not links and have entries in the matrix
  std::vector<double> m_sums;            // of m_mixed, over its matrix nodes
  std::vector<Update> m_updates;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper> m_factor;
  Eigen::SparseMatrix<double> m_pattern; // of A_cc for which m_factor is ordered
  Eigen::VectorXd m_t;                   // nodes of the cell, x and y in turn
};

} // namespace matrigrate
