#pragma once

#include "base/adjacency.hpp"
#include "base/vector.hpp"

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

/// A list that stays valid while particles move: it reaches `skin` further than asked for and is built again once two
/// particles could have come closer than that unseen (Verlet 1967). Pairs in the skin carry zero kernel weights, and
/// rows are sorted, so sums over the list have the same bits whenever it was last built.
class VerletList {
public:
  /// @param reach  pairs up to this distance are always listed [um]
  /// @param skin   extra distance [um], > 0
  VerletList(double reach, double skin) : m_reach(reach), m_skin(skin) {}

  /// Makes the list valid for the positions x.  @return whether it was built again
  bool update(std::span<const Vec2> x, double period_x);

  const Adjacency& pairs() const { return m_pairs; }

private:
  double m_reach;
  double m_skin;
  std::vector<Vec2> m_x_built;
  Adjacency m_pairs;
};

} // namespace matrigrate
