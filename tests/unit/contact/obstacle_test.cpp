#include "contact/degrade.hpp"
#include "contact/elastic.hpp"
#include "contact/viscous.hpp"
#include "ecm/law/material.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace matrigrate;

namespace {

/// Fluid but for one particle of an obstacle, which lies 0.7 um outside of segment 10.
struct Pillar : Scene {
  std::uint32_t k = 3;
  Vec2 out;

  Pillar() {
    std::ranges::fill(ecm.f, 0.0);
    out = -perpendicular(c.x[11] - c.x[10]).normalized();
    ecm.x[k] = 0.5 * (c.x[10] + c.x[11]) + 0.7 * out;
    ecm.f[k] = 1.0;
    ecm.clamped[k] = 1;
    ecm.obstacle.assign(ecm.size(), 0);
    ecm.obstacle[k] = 1;
  }
};

/// The nodes of all terms of a kind.
template <class Weight>
bool has_entry(const DragTerms<Weight>& terms, std::uint32_t node) {
  return std::ranges::find(terms.node, node) != terms.node.end();
}

} // namespace

TEST(Obstacle, ResistsTheCellAndHasNoTermOfItsOwn) {
  const Pillar s;
  const Assembled a = assemble(s.ecm.size() + s.c.size(), [&](std::span<Vec2> force, DragSystem& A) {
    add_elastic_contact(s.ecm, s.c, s.p, s.nearby(), 0.4, s.first(), force, A);
    add_viscous_contact(s.ecm, s.c, std::vector<std::uint8_t>(s.c.size(), 0), s.p, SegmentGrid(s.c, s.reach), s.first(),
                        A);
  });
  const double expected = obstacle_contact * 0.5 * moduli(s.p.ecm).K * 2.0 * 1.0;
  EXPECT_LT((a.force[s.first() + 10] + 0.5 * expected * s.out).norm(), 1e-9);
  EXPECT_LT((a.force[s.first() + 11] + 0.5 * expected * s.out).norm(), 1e-9);
  EXPECT_FALSE(has_entry(a.A.directed, s.k));
  EXPECT_FALSE(has_entry(a.A.links, s.k));
  EXPECT_TRUE(has_entry(a.A.directed, s.first() + 10));
  EXPECT_TRUE(has_entry(a.A.links, s.first() + 10)) << "its drag is that of a wall";
}

TEST(Obstacle, IsImplicitAlongTheNormal) {
  const Pillar s;
  Pillar after = s;
  const double speed = 0.02;
  for (const std::size_t i : {10U, 11U}) after.c.x[i] += 0.4 * speed * s.out;
  const auto contact = [](const Pillar& scene) {
    return assemble(scene.ecm.size() + scene.c.size(), [&](std::span<Vec2> force, DragSystem& A) {
      add_elastic_contact(scene.ecm, scene.c, scene.p, scene.nearby(), 0.4, scene.first(), force, A);
    });
  };
  const Assembled a = contact(s);
  std::vector<Vec2> v(a.force.size(), Vec2::Zero());
  for (const std::size_t i : {10U, 11U}) v[s.first() + i] = speed * s.out;
  const Vec2 foreseen = a.force[s.first() + 10] - drag_force(a.A, v)[s.first() + 10];
  EXPECT_LT((foreseen - contact(after).force[s.first() + 10]).norm(), 1e-3 * foreseen.norm());
}

TEST(Obstacle, IsNeverDegraded) {
  Pillar s;
  s.ecm.rho[s.k] = 1.7; // under a pressure at which solid is degraded
  const std::vector<std::uint8_t> on_protrusion(s.c.size(), 1);
  const std::vector<Vec2> tips{s.ecm.x[s.k]};
  degrade(s.ecm, s.p, s.nearby(), {on_protrusion}, tips, 5.0);
  EXPECT_EQ(s.ecm.f[s.k], 1.0);
  s.ecm.x[s.k] -= 4.0 * s.out; // deep inside the cell
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, s.nearby()), 0U);
  s.ecm.obstacle.clear();
  s.ecm.clamped[s.k] = 0;
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, s.nearby()), 1U) << "without the obstacle it would be";
}
