#pragma once

#include "solve/drag_system.hpp"

#include <Eigen/SparseCholesky>

#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// The nodes where terms weigh more than pair drag, solved for exactly: all nodes behind the matrix, and those of the
/// matrix whose terms make up more than a share of their diagonal. Terms over very many nodes are left out.
/// Test: tests/unit/solve/two_level_test.cpp
class Patch {
public:
  /// Chooses the nodes and factorises their part of A.
  /// @param diagonal  mean_diagonal() of A
  void factorise(const DragSystem& A, std::span<const double> diagonal);

  bool contains(std::size_t node) const { return m_local[node] >= 0; }

  /// z := A_patch^-1 r on the nodes of the patch.
  void solve(std::span<const Vec2> r, std::span<Vec2> z);

private:
  std::vector<std::uint32_t> m_nodes;
  std::vector<std::int32_t> m_local; // place in m_nodes, or -1
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_factor;
  Eigen::VectorXd m_r;
};

} // namespace matrigrate
