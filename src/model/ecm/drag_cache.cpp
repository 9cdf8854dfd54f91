#include "ecm/drag_cache.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace matrigrate {

DragTiles::DragTiles(std::span<const Vec2> X, double spacing) {
  std::map<std::pair<double, double>, std::vector<std::uint32_t>> tiles;
  const double width = 8.0 * spacing;
  for (std::uint32_t i = 0; i < X.size(); ++i)
    tiles[{std::floor(X[i].y() / width), std::floor(X[i].x() / width)}].push_back(i);
  m_first.push_back(0);
  for (const auto& [place, particles] : tiles) {
    m_particle.insert(m_particle.end(), particles.begin(), particles.end());
    m_first.push_back(static_cast<std::uint32_t>(m_particle.size()));
  }
}

void DragTiles::refresh(std::span<const Vec2> x, double lag, std::span<const Vec2> before,
                        std::vector<Vec2>& x_drag) const {
  if (before.size() != x.size()) before = x;
  x_drag.resize(x.size());
  const double max_squared = lag * lag;
  const auto refresh_tile = [&](std::size_t k) {
    const auto tile = std::span(m_particle).subspan(m_first[k], m_first[k + 1] - m_first[k]);
    const bool stays =
        std::ranges::all_of(tile, [&](std::uint32_t i) { return !((x[i] - before[i]).squaredNorm() > max_squared); });
    const std::span<const Vec2> from = stays ? before : x;
    for (const std::uint32_t i : tile) x_drag[i] = from[i];
  };
  parallel_for(m_first.size() - 1, refresh_tile, 32);
}

/// Brings the pattern up to date.   @return 1 for each row that has changed; empty: none
std::vector<std::uint8_t> DragCache::refresh_pattern(const VerletList& neighbours,
                                                     std::span<const std::uint8_t> clamped) {
  const std::size_t unseen = neighbours.updates() - m_updates_seen;
  m_updates_seen = neighbours.updates();
  if (unseen == 0) return {};
  std::vector<std::uint8_t> changed(neighbours.changed().begin(), neighbours.changed().end());
  if (unseen > 1) changed.assign(changed.size(), 1); // only the last update is known row by row
  m_pattern.update(neighbours.pairs(), clamped, changed);
  return changed;
}

void DragCache::assemble(const EcmState& ecm, const EcmParameters& p, const VerletList& neighbours,
                         std::span<const Vec2> x_drag, double lag, double theta, DragSystem& A) {
  const std::vector<std::uint8_t> changed = refresh_pattern(neighbours, ecm.clamped);
  m_tiles.refresh(ecm.x, lag, x_drag, m_x_drag);
  m_rows.assemble(ecm, m_x_drag, p, neighbours.pairs(), m_pattern, changed, theta, A);
}

} // namespace matrigrate
