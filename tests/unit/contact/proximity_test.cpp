#include "contact/proximity.hpp"

#include "cell/geometry.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace matrigrate;

TEST(SegmentGrid, FindsEverySegmentWithinReachInAscendingOrder) {
  const CortexState c = wavy_cortex(small_cell());
  const double reach = 2.0;
  const SegmentGrid grid(c, reach);
  std::size_t found = 0;
  for (double y = -14.0; y < 10.0; y += 0.3)
    for (double x = -9.0; x < 15.0; x += 0.3) {
      const std::span<const std::uint32_t> near = grid.near({x, y});
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      const std::set<std::uint32_t> set(near.begin(), near.end());
      EXPECT_EQ(set.size(), near.size());
      for (std::uint32_t i = 0; i < c.size(); ++i) {
        if (closest_point({x, y}, c.x[i], c.x[c.next(i)]).from.norm() >= reach) continue;
        ++found;
        EXPECT_TRUE(set.contains(i)) << x << ", " << y << " misses segment " << i;
      }
    }
  EXPECT_GT(found, 1000U);
}

TEST(SegmentGrid, FindsNothingFarAway) {
  const SegmentGrid grid(wavy_cortex(small_cell()), 2.0);
  EXPECT_TRUE(grid.near({100.0, 0.0}).empty());
  EXPECT_TRUE(grid.near({3.0, -30.0}).empty());
}

TEST(SegmentGrid, KnowsWhichPointsMayHaveASegmentNear) {
  const SegmentGrid grid(wavy_cortex(small_cell()), 2.0);
  std::vector<Vec2> points;
  for (double y = -30.0; y < 30.0; y += 0.7)
    for (double x = -30.0; x < 30.0; x += 0.7) points.emplace_back(x, y);
  const std::vector<std::uint32_t> found = grid.candidates(points);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  const std::set<std::uint32_t> set(found.begin(), found.end());
  for (std::uint32_t k = 0; k < points.size(); ++k) EXPECT_EQ(set.contains(k), !grid.near(points[k]).empty());
  EXPECT_LT(found.size(), points.size() / 2);
}

TEST(NearbySolid, AreTheClosestSegmentsOfAllParticles) {
  const Scene s = touching_scene();
  const std::vector<NearbyParticle> nearby = s.nearby();
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < s.ecm.size(); ++k) {
    double closest = 1e9;
    for (std::size_t i = 0; i < s.c.size(); ++i)
      closest = std::min(closest, closest_point(s.ecm.x[k], s.c.x[i], s.c.x[s.c.next(i)]).from.norm());
    if (closest >= s.reach || s.ecm.clamped[k]) continue;
    ASSERT_LT(next, nearby.size());
    const NearbyParticle& e = nearby[next++];
    EXPECT_EQ(e.particle, k);
    EXPECT_NEAR(std::abs(e.distance), closest, 1e-12);
    EXPECT_EQ(e.distance < 0.0, contains(s.c, s.ecm.x[k])) << "particle " << k;
    const Vec2 at = s.c.x[e.segment] + e.s * (s.c.x[s.c.next(e.segment)] - s.c.x[e.segment]);
    EXPECT_LT((at + e.distance * e.normal - s.ecm.x[k]).norm(), 1e-9);
    EXPECT_NEAR(e.normal.norm(), 1.0, 1e-12);
  }
  EXPECT_EQ(next, nearby.size());
  EXPECT_TRUE(std::ranges::any_of(nearby, [](const NearbyParticle& e) { return e.distance < 0.0; }));
  EXPECT_TRUE(std::ranges::any_of(nearby, [](const NearbyParticle& e) { return e.s == 0.0 || e.s == 1.0; }));
}

TEST(NearbySolid, LeaveFluidAndClampedParticlesOut) {
  Scene s = touching_scene();
  const std::size_t all = s.nearby().size();
  s.ecm.f[s.nearby()[3].particle] = 0.0;
  s.ecm.clamped[s.nearby()[5].particle] = 1;
  EXPECT_EQ(s.nearby().size(), all - 2);
}

TEST(NearbySolid, GiveANormalEvenToAParticleOnTheCortex) {
  Scene s = touching_scene();
  const std::uint32_t k = s.nearby().front().particle;
  s.ecm.x[k] = 0.5 * (s.c.x[7] + s.c.x[8]);
  for (const NearbyParticle& e : s.nearby())
    if (e.particle == k) {
      EXPECT_NEAR(e.distance, 0.0, 1e-12);
      EXPECT_NEAR(e.normal.norm(), 1.0, 1e-12);
      EXPECT_GT(e.normal.dot(normal(s.c, 7)), 0.9);
    }
}
