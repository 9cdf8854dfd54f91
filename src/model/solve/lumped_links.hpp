#pragma once

#include "solve/field.hpp"
#include "solve/grid.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace matrigrate {

/// Coarse-grid approximation of the links: each node a of the cell moves with the mean of its linked matrix nodes and
/// is resisted only by its own drag. Its effect on smooth fields of the matrix is
///   E = diag(g_k) - sum over a of g_a g_a^T / T_a,   g_k = sum_a g_ka,   T_a = own drag + sum_k g_ka.
/// E is positive semidefinite. On a grid it is P^T E P.
/// Test: tests/unit/solve/solve_test.cpp
class LumpedLinks {
public:
  /// @param own  drag of the nodes of the cell [nN s/um]
  void clear(std::span<const double> own);

  /// The links of a node of the matrix: nodes of the cell and drags; only drags above 0 count.
  void add(std::uint32_t node, std::span<const std::pair<std::uint32_t, double>> drags);

  /// Call after the last add().
  void close();

  std::size_t size() const { return m_nodes.size(); }
  std::span<const std::uint32_t> nodes() const { return m_nodes; } ///< the linked nodes of the matrix
  float drag(std::size_t k) const { return m_g[k]; }               ///< g_k

  /// Lower half of A += P^T E P for a grid located at nodes().
  void add_to(const Grid& grid, Eigen::MatrixXf& A) const;

  /// Finds E P x for a grid located at nodes().
  void multiply(const Grid& grid, const Field& x);

  /// r -= P^T E P x of the last multiply(), by the same grid.
  void subtract_from(const Grid& grid, Field& r) const;

private:
  std::vector<std::uint32_t> m_nodes;
  std::vector<float> m_g;
  std::vector<std::uint32_t> m_first, m_cell_dofs;
  std::vector<float> m_drag;
  std::vector<float> m_T;            // after close(): 1 / T
  std::vector<float> m_sum, m_force; // of the nodes of the cell, and E P x; x and y interleaved
};

} // namespace matrigrate
