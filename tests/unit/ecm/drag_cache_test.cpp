#include "ecm/drag_cache.hpp"

#include "body.hpp"
#include "same_drag.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace matrigrate;

namespace {

/// The drag at positions x, computed from nothing.
DragSystem computed(EcmState ecm, const std::vector<Vec2>& x, const EcmParameters& p) {
  ecm.x = x;
  DragSystem A;
  assemble_viscosity(ecm, p, RowPattern(neighbours_within(ecm.x, 8.0, ecm.period_x), ecm.clamped), A, 0.3);
  return A;
}

/// Moves twenty particles in the middle.
void stir(EcmState& ecm) {
  for (std::size_t i = ecm.size() / 2; i < ecm.size() / 2 + 20; ++i) ecm.x[i] += Vec2(0.1, -0.07);
}

} // namespace

TEST(DragCache, HasTheSameBitsWhereAFewRowsOfTheListChange) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  std::size_t mended = 0;
  for (int step = 0; step < 12; ++step) {
    const auto changed = list.update(ecm.x, ecm.period_x);
    if (!changed.empty() && std::ranges::count(changed, 1) < std::ssize(changed)) ++mended;
    cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
    expect_same(kept, computed(ecm, ecm.x, p));
    stir(ecm);
  }
  EXPECT_GE(mended, 3U);
}

TEST(DragCache, MissesNoUpdateOfTheList) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  for (int step = 0; step < 20; ++step) {
    list.update(ecm.x, ecm.period_x);
    if (step % 5 == 0) {
      cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
      expect_same(kept, computed(ecm, ecm.x, p));
    }
    stir(ecm);
  }
  EXPECT_GT(list.updates(), 4U);
}

TEST(DragCache, ComputesRowsAgainThatHaveBeenAddedTo) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  list.update(ecm.x, ecm.period_x);
  DragCache cache(ecm, p);
  DragSystem kept;
  cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{50, 51}, {51, 50}}) {
    ASSERT_NE(kept.pairs.find(i, j), nullptr);
    *kept.pairs.find(i, j) += 1.0F;
    kept.diagonal[i] += 1.0;
    kept.touched[i] = 1;
  }
  cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
  expect_same(kept, computed(ecm, ecm.x, p));
}

TEST(DragCache, TakesTheDragWhereItWasUntilSomethingMovesBeyondTheLag) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const std::vector<Vec2> before = ecm.x;
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  for (Vec2& x : ecm.x) x += Vec2(0.009, 0.0);
  list.update(ecm.x, ecm.period_x);
  cache.assemble(ecm, p, list, before, 0.01, 0.3, kept);
  EXPECT_EQ(cache.x_drag(), before);
  expect_same(kept, computed(ecm, before, p));
  cache.assemble(ecm, p, list, before, 0.008, 0.3, kept);
  EXPECT_EQ(cache.x_drag(), ecm.x);
  expect_same(kept, computed(ecm, ecm.x, p));
}

TEST(DragTiles, AreRefreshedTogetherWhereOneParticleHasMovedFurtherThanTheLag) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 80.0, 40.0, 0.0);
  const DragTiles tiles(ecm.X, p.particle_spacing);
  std::vector<Vec2> x_drag;
  tiles.refresh(ecm.x, 0.01, x_drag);
  EXPECT_EQ(x_drag, ecm.x);
  const auto tile_of = [&](std::size_t i) {
    const double width = 8.0 * p.particle_spacing;
    return std::pair(std::floor(ecm.X[i].x() / width), std::floor(ecm.X[i].y() / width));
  };
  const std::vector<Vec2> before = ecm.x;
  const std::size_t far = ecm.size() - 3; // in the last tile
  ASSERT_NE(tile_of(3), tile_of(far));
  for (Vec2& x : ecm.x) x += Vec2(0.009, 0.0);
  ecm.x[3] = before[3] + Vec2(0.0, -0.011);
  tiles.refresh(ecm.x, 0.01, x_drag);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    EXPECT_EQ(x_drag[i], tile_of(i) == tile_of(3) ? ecm.x[i] : before[i]) << i;
  tiles.refresh(ecm.x, 0.0, x_drag);
  EXPECT_EQ(x_drag, ecm.x);
}
