#include "contact/elastic.hpp"

#include "ecm/law/material.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

Assembled contact_of(const Scene& s) {
  return assemble(s.ecm.size() + s.c.size(), [&](std::span<Vec2> force, DragSystem& A) {
    add_elastic_contact(s.ecm, s.c, s.p, s.nearby(), time_step, s.first(), force, A);
  });
}

} // namespace

TEST(ContactPressure, FallsLinearlyToZeroAtTheRange) {
  const Parameters p;
  const double K = 0.2 / (3.0 * (1.0 - 0.9)); // 667 Pa
  EXPECT_NEAR(contact_pressure(0.0, p), K, 1e-12);
  EXPECT_NEAR(contact_pressure(0.7, p), 0.5 * K, 1e-12);
  EXPECT_NEAR(contact_pressure(-0.28, p), 1.2 * K, 1e-12);
  EXPECT_NEAR(contact_pressure(1.399, p), K * 0.001 / 1.4, 1e-12);
  EXPECT_EQ(contact_pressure(1.4, p), 0.0);
  EXPECT_EQ(contact_pressure(3.0, p), 0.0);
}

TEST(ElasticContact, IsNothingWhereTheMatrixIsOutOfReach) {
  const Scene s; // the hole reaches 1.9 um beyond the cell
  EXPECT_EQ(largest(contact_of(s).force), 0.0);
}

TEST(ElasticContact, PushesTheParticleOutwardsByPressureTimesItsArea) {
  Scene s;
  for (std::size_t k = 0; k < s.ecm.size(); ++k) s.ecm.f[k] = 0.0;
  const std::uint32_t k = 3;
  s.ecm.clamped[k] = 0;
  s.ecm.f[k] = 0.5;
  s.ecm.x[k] = 0.5 * (s.c.x[10] + s.c.x[11]);
  const Vec2 out = -perpendicular(s.c.x[11] - s.c.x[10]).normalized();
  s.ecm.x[k] += 0.7 * out;
  const std::vector<Vec2> force = contact_of(s).force;
  const double expected = 0.5 * 0.5 * moduli(s.p.ecm).K * 2.0 * 1.0;
  EXPECT_LT((force[k] - expected * out).norm(), 1e-9);
  EXPECT_LT((force[s.ecm.size() + 10] + 0.5 * expected * out).norm(), 1e-9);
  EXPECT_LT((force[s.ecm.size() + 11] + 0.5 * expected * out).norm(), 1e-9);
}

TEST(ElasticContact, HasNeitherNetForceNorMoment) {
  const Scene s = touching_scene();
  const Assembled a = contact_of(s);
  ASSERT_GT(largest(a.force), 0.01);
  EXPECT_LT(net_force(a.force).norm(), 1e-12 * largest(a.force));
  EXPECT_LT(std::abs(net_torque(a.force, s.positions())), 1e-10 * largest(a.force));
  const std::vector<Vec2> drag = drag_force(a.A, stirred(a.force.size()));
  EXPECT_LT(net_force(drag).norm(), 1e-11 * largest(drag));
}

TEST(ElasticContact, TurnsWithTheScene) {
  const Motion motion;
  const Scene s = touching_scene();
  const Assembled here = contact_of(s);
  const Assembled there = contact_of(moved(s, motion));
  for (std::size_t i = 0; i < here.force.size(); ++i)
    EXPECT_LT((there.force[i] - motion.R * here.force[i]).norm(), 1e-9 * largest(here.force));
}

TEST(ElasticContact, IsImplicitAlongTheNormal) {
  const Scene s = touching_scene();
  Scene after = s; // one particle comes closer, the nearest of those well within a segment
  const std::vector<NearbyParticle> nearby = s.nearby();
  const auto inner = std::ranges::find_if(
      nearby, [](const NearbyParticle& e) { return e.s > 0.2 && e.s < 0.8 && e.distance > 0.1 && e.distance < 1.0; });
  ASSERT_NE(inner, nearby.end());
  const NearbyParticle& e = *inner;
  const double speed = -0.01;
  after.ecm.x[e.particle] += time_step * speed * e.normal;
  const std::vector<Vec2> grown = contact_of(after).force;
  const Assembled a = contact_of(s);
  std::vector<Vec2> v(a.force.size(), Vec2::Zero());
  v[e.particle] = speed * e.normal;
  const std::vector<Vec2> drag = drag_force(a.A, v);
  EXPECT_LT((a.force[e.particle] - drag[e.particle] - grown[e.particle]).norm(), 1e-9);
  EXPECT_GT(drag[e.particle].norm(), 1e-4);
}
