#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Neighbour lists of moving particles. Test: tests/unit/sph/sph_test.cpp
namespace matrigrate {

/// All pairs within the distance `reach`, by a cell list. Rows are sorted, so the result depends on the positions
/// only.
/// @param x         positions [um]; finite
/// @param reach     [um], > 0
/// @param period_x  period along x [um]; 0: not periodic
/// @throws std::invalid_argument if a period holds fewer than three cells of size `reach`, or a position is not finite
Adjacency neighbours_within(std::span<const Vec2> x, double reach, double period_x);

/// Verlet list (Verlet 1967): it reaches `skin` further than required, and is updated when two particles could have
/// approached by more than the skin since. If few particles have moved, only their rows are updated. Pairs in the skin
/// have zero kernel weight and rows are sorted, so sums over the list have the same bits whenever it was last updated.
class VerletList {
public:
  /// @param reach  pairs up to this distance are always listed [um]
  /// @param skin   extra distance [um], > 0
  VerletList(double reach, double skin) : m_reach(reach), m_skin(skin) {}

  /// Makes the list valid for the positions x.
  /// @return 1 for each row that was rebuilt, 0 for the others; empty if none was
  std::span<const std::uint8_t> update(std::span<const Vec2> x, double period_x);

  const Adjacency& pairs() const { return m_pairs; }

  std::size_t updates() const { return m_updates; } ///< how often rows have changed since the start
  /// 1 for each row that changed in the last of these updates, 0 for the others.
  std::span<const std::uint8_t> changed() const { return m_changed; }

private:
  std::vector<std::uint32_t> moved(std::span<const Vec2> x) const;
  void mend(std::span<const Vec2> x, double period_x, std::span<const std::uint32_t> moved);
  void list_anew(std::span<const Vec2> x, double period_x);
  bool replace(std::uint32_t i, std::span<const std::uint32_t> row);
  bool insert(std::uint32_t i, std::uint32_t j);
  void remove(std::uint32_t i, std::uint32_t j);

  double m_reach;
  double m_skin;
  std::vector<Vec2> m_x_listed; // position of each particle when its row was last built
  Adjacency m_pairs;            // those of neighbours_within(m_x_listed, m_reach + m_skin), with spare capacity
  std::vector<std::uint8_t> m_changed;
  std::size_t m_updates = 0;
};

} // namespace matrigrate
