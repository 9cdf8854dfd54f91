#pragma once

#include "base/vector.hpp"
#include "state/cortex.hpp"
#include "state/ecm.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Which solid particles of the matrix are near the cell. Test: tests/unit/contact/contact_test.cpp
namespace matrigrate {

/// A solid particle (f_degr > 0) and the segment of the cortex that is closest to it.
struct NearbyParticle {
  std::uint32_t particle;
  std::uint32_t segment;
  double s;        ///< closest point along the segment, 0 at its first end and 1 at its second [-]
  double distance; ///< outside the cell positive [um]
  Vec2 normal;     ///< unit vector of growing distance, at the particle
};

/// The closest place of a cortex to a point.
struct NearestSegment {
  std::uint32_t segment;
  double s;        ///< along the segment, 0 at its first end and 1 at its second [-]
  double distance; ///< outside the cell positive [um]
  Vec2 normal;     ///< unit vector of growing distance, at the point
};

/// Segments of the cortex in a grid, to find those near a point.
class SegmentGrid {
public:
  /// @param reach  segments up to this distance from a point are found [um], > 0
  SegmentGrid(const CortexState& c, double reach);

  /// A superset of the segments within reach of p, in ascending order.
  std::span<const std::uint32_t> near(const Vec2& p) const;

  /// Those of the points that may have a segment near, in ascending order.
  std::vector<std::uint32_t> candidates(std::span<const Vec2> points) const;

private:
  bool covers(const Vec2& p) const {
    return p.x() >= m_low.x() && p.x() <= m_high.x() && p.y() >= m_low.y() && p.y() <= m_high.y();
  }
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  Vec2 m_low, m_high;
  double m_per_bin; // over the width of a bin [1/um]
  std::size_t m_columns, m_rows;
  std::vector<std::uint32_t> m_first;
  std::vector<std::uint32_t> m_segments;
};

/// The segment of a cortex that is closest to a point within the grid's reach, if there is one.
/// @param reach  that of the grid [um]
std::optional<NearestSegment> closest_segment(const Vec2& point, const CortexState& c, const SegmentGrid& grid,
                                              double reach);

/// The encounters of all free solid particles, and of those of obstacles, within the grid's reach, in the order of the
/// particles.
/// @param reach  that of the grid [um]
std::vector<NearbyParticle> nearby_solid(const EcmState& ecm, const CortexState& c, const SegmentGrid& grid,
                                         double reach);

} // namespace matrigrate
