#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

#include <cstdint>
#include <span>
#include <vector>

/// Who meets whom. Test: tests/unit/sph/neighbours_test.cpp
namespace matrigrate {

/// All pairs no further apart than `reach`, found through a grid of cells. Rows are sorted, so the list depends on the
/// positions alone.
/// @param x         positions [um]; finite
/// @param reach     [um], > 0
/// @param period_x  period along x [um]; 0: not periodic
/// @throws std::invalid_argument if a period holds fewer than three cells of size `reach`, or a position is not finite
Adjacency neighbours_within(std::span<const Vec2> x, double reach, double period_x);

/// A list that stays valid while particles move: it reaches `skin` further than asked for and is mended once two
/// particles could have come closer than that unseen (Verlet 1967), where particles have moved if these are few. Pairs
/// in the skin carry zero kernel weights, and rows are sorted, so sums over the list have the same bits whenever it was
/// last mended.
class VerletList {
public:
  /// @param reach  pairs up to this distance are always listed [um]
  /// @param skin   extra distance [um], > 0
  VerletList(double reach, double skin) : m_reach(reach), m_skin(skin) {}

  /// Makes the list valid for the positions x.
  /// @return 1 for each row that was made anew, 0 for the others; empty if none was
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
  std::vector<Vec2> m_x_listed; // where each particle was when its row was last made
  Adjacency m_pairs;            // those of neighbours_within(m_x_listed, m_reach + m_skin), with room
  std::vector<std::uint8_t> m_changed;
  std::size_t m_updates = 0;
};

} // namespace matrigrate
