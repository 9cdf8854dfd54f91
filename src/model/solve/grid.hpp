#pragma once

#include "base/vector.hpp"
#include "solve/field.hpp"

#include <Eigen/SparseCore>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace matrigrate {

/// A square grid of points with bilinear interpolation to nodes at arbitrary positions: the prolongation matrix P.
/// Points can be removed; a removed point has the value zero. Test: tests/unit/solve/multigrid_test.cpp
class Grid {
public:
  /// The four points around a node and their weights; 0 for removed points.
  struct Around {
    std::array<std::uint32_t, 4> point{};
    std::array<float, 4> weight{};
  };

  Grid() = default;

  /// A grid over all of x with some margin.   @param spacing  [um], > 0
  Grid(std::span<const Vec2> x, double spacing);

  /// A grid of twice the spacing over the same area.
  Grid coarser() const;

  /// The same points, without interpolation to nodes.
  Grid without_nodes() const;

  std::size_t size() const { return m_points; }
  double spacing() const { return m_spacing; }

  /// Positions of the points that were not removed [um].
  std::vector<Vec2> points() const;

  /// Removes the points with keep = 0 and renumbers the others in order.
  void leave_out(std::span<const std::uint8_t> keep);

  /// Sets the interpolation to nodes at x. Nodes with free = 0 have a zero row in P.
  void locate(std::span<const Vec2> x, std::span<const std::uint8_t> free);

  /// Sets the interpolation to some nodes of the same grid located at all of them.
  void take(const Grid& located, std::span<const std::uint32_t> nodes);

  const std::vector<Around>& around() const { return m_around; } ///< of the nodes
  Eigen::SparseMatrix<double> P() const;

  /// a = P^T r.
  void restrict_to(const Field& r, Field& a) const;

private:
  Around weigh(const Vec2& x) const;

  double m_spacing = 0.0;
  Vec2 m_low = Vec2::Zero();
  std::size_t m_columns = 0, m_rows = 0, m_points = 0;
  std::vector<std::int32_t> m_number; // of a point; -1 if it was removed
  std::vector<Around> m_around;       // of the nodes
};

} // namespace matrigrate
