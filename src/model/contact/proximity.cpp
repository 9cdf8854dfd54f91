#include "contact/proximity.hpp"

#include "base/points_in.hpp"
#include "cell/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace matrigrate {

namespace {

/// Outward normal of segment i, not normalised.
Vec2 outward(const CortexState& c, std::size_t i) { return -perpendicular(c.x[c.next(i)] - c.x[i]); }

/// Outward direction at the closest point: of the segment, or of both segments that meet at its end.
Vec2 outward_at(const CortexState& c, std::size_t i, double s) {
  Vec2 own = outward(c, i).normalized();
  if (s <= 0.0) return own + outward(c, c.previous(i)).normalized();
  if (s >= 1.0) return own + outward(c, c.next(i)).normalized();
  return own;
}

} // namespace

SegmentGrid::SegmentGrid(const CortexState& c, double reach) : m_per_bin(2.0 / reach) {
  m_low = m_high = c.x[0];
  for (const Vec2& x : c.x) {
    m_low = m_low.cwiseMin(x);
    m_high = m_high.cwiseMax(x);
  }
  m_low.array() -= reach;
  m_high.array() += reach;
  m_columns = static_cast<std::size_t>((m_high.x() - m_low.x()) * m_per_bin) + 1;
  m_rows = static_cast<std::size_t>((m_high.y() - m_low.y()) * m_per_bin) + 1;
  const auto each_bin = [&](std::size_t i, const auto& action) {
    const Vec2 low = c.x[i].cwiseMin(c.x[c.next(i)]).array() - reach;
    const Vec2 high = c.x[i].cwiseMax(c.x[c.next(i)]).array() + reach;
    const std::size_t left = column(low.x()), right = column(high.x()), top = row(high.y());
    for (std::size_t r = row(low.y()); r <= top; ++r)
      for (std::size_t q = left; q <= right; ++q) action(r * m_columns + q);
  };
  m_first.assign(m_columns * m_rows + 1, 0);
  for (std::size_t i = 0; i < c.size(); ++i) each_bin(i, [&](std::size_t bin) { ++m_first[bin + 1]; });
  for (std::size_t bin = 1; bin < m_first.size(); ++bin) m_first[bin] += m_first[bin - 1];
  m_segments.resize(m_first.back());
  std::vector<std::uint32_t> end(m_first.begin(), m_first.end() - 1);
  for (std::size_t i = 0; i < c.size(); ++i)
    each_bin(i, [&](std::size_t bin) { m_segments[end[bin]++] = static_cast<std::uint32_t>(i); });
}

std::size_t SegmentGrid::column(double x) const {
  return std::min(static_cast<std::size_t>(std::max(0.0, (x - m_low.x()) * m_per_bin)), m_columns - 1);
}

std::size_t SegmentGrid::row(double y) const {
  return std::min(static_cast<std::size_t>(std::max(0.0, (y - m_low.y()) * m_per_bin)), m_rows - 1);
}

std::span<const std::uint32_t> SegmentGrid::near(const Vec2& p) const {
  if (!covers(p)) return {};
  const std::size_t bin = row(p.y()) * m_columns + column(p.x());
  return {m_segments.data() + m_first[bin], static_cast<std::size_t>(m_first[bin + 1] - m_first[bin])};
}

std::vector<std::uint32_t> SegmentGrid::candidates(std::span<const Vec2> points) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t k : points_in({m_low, m_high}, points))
    if (!near(points[k]).empty()) found.push_back(k);
  return found;
}

std::optional<NearestSegment> closest_segment(const Vec2& point, const CortexState& c, const SegmentGrid& grid,
                                              double reach) {
  double d2 = reach * reach;
  ClosestPoint closest{0.0, Vec2::Zero()};
  std::uint32_t segment = std::numeric_limits<std::uint32_t>::max();
  for (const std::uint32_t i : grid.near(point)) {
    const ClosestPoint q = closest_point(point, c.x[i], c.x[c.next(i)]);
    if (q.from.squaredNorm() >= d2) continue;
    d2 = q.from.squaredNorm();
    closest = q;
    segment = i;
  }
  if (segment == std::numeric_limits<std::uint32_t>::max()) return {};
  const Vec2 out = outward_at(c, segment, closest.s);
  const double d = std::sqrt(d2);
  const double sign = closest.from.dot(out) < 0.0 ? -1.0 : 1.0;
  const Vec2 n = d > 1e-9 ? Vec2(sign * closest.from / d) : Vec2(outward(c, segment).normalized());
  return NearestSegment{segment, closest.s, sign * d, n};
}

std::vector<NearbyParticle> nearby_solid(const EcmState& ecm, const CortexState& c, const SegmentGrid& grid,
                                         double reach) {
  std::vector<NearbyParticle> found;
  for (const std::uint32_t k : grid.candidates(ecm.x)) {
    if (ecm.f[k] <= 0.0 || (ecm.clamped[k] && !ecm.in_obstacle(k))) continue;
    if (const auto near = closest_segment(ecm.x[k], c, grid, reach))
      found.push_back({k, near->segment, near->s, near->distance, near->normal});
  }
  return found;
}

} // namespace matrigrate
