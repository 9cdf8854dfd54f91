#include "cell/geometry.hpp"
#include "contact/degrade.hpp"
#include "contact/elastic.hpp"
#include "contact/proximity.hpp"
#include "contact/viscous.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/viscosity.hpp"
#include "scene.hpp"
#include "sph/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace matrigrate;

namespace {

Assembled contact_of(const Scene& s) {
  return assemble(s.ecm.size() + s.c.size(), [&](std::span<Vec2> force, DragSystem& A) {
    NodeForces on_matrix;
    add_elastic_contact(s.ecm, s.c, s.p, s.nearby(), time_step, s.first(), force, on_matrix, A);
    on_matrix.add_to(force);
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
    NodeForces on_matrix;
    add_elastic_contact(s.ecm, s.c, s.p, s.nearby(), 0.4, s.first(), force, on_matrix, A);
    on_matrix.add_to(force);
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
      NodeForces on_matrix;
      add_elastic_contact(scene.ecm, scene.c, scene.p, scene.nearby(), 0.4, scene.first(), force, on_matrix, A);
      on_matrix.add_to(force);
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
  degrade(s.ecm, s.p, s.nearby(), {on_protrusion}, tips, 5.0, Laws(s.p));
  EXPECT_EQ(s.ecm.f[s.k], 1.0);
  s.ecm.x[s.k] -= 4.0 * s.out; // deep inside the cell
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, s.nearby()), 0U);
  s.ecm.obstacle.clear();
  s.ecm.clamped[s.k] = 0;
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, s.nearby()), 1U) << "without the obstacle it would be";
}

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

namespace {

/// @param soft  of the segments; empty: none grows
DragSystem coupling(const Scene& s, std::vector<std::uint8_t> soft = {}) {
  soft.resize(s.c.size(), 0);
  return assemble(s.ecm.size() + s.c.size(),
                  [&](std::span<Vec2>, DragSystem& A) {
                    add_viscous_contact(s.ecm, s.c, soft, s.p, SegmentGrid(s.c, s.reach), s.first(), A);
                  })
      .A;
}

/// Force on the cell while it moves by and the matrix rests.
Vec2 drag_on_cell(const Scene& s, const Vec2& speed, const std::vector<std::uint8_t>& soft = {}) {
  std::vector<Vec2> v(s.ecm.size(), Vec2::Zero());
  v.resize(s.ecm.size() + s.c.size(), speed);
  const std::vector<Vec2> f = drag_force(coupling(s, soft), v);
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = s.ecm.size(); i < f.size(); ++i) sum -= f[i];
  return sum;
}

/// Fluid all around but for particle k, which lies x on the x axis.
Scene alone_at(double x, std::uint32_t k) {
  Scene s;
  std::fill(s.ecm.f.begin(), s.ecm.f.end(), 0.0);
  std::fill(s.ecm.clamped.begin(), s.ecm.clamped.end(), 1);
  s.p.contact.sample_spacing = 10.0; // one sample a segment
  s.ecm.clamped[k] = 0;
  s.ecm.x[k] = {x, 0.0};
  return s;
}

} // namespace

TEST(ViscousContact, DoesNothingWhereCellAndMatrixMoveTogether) {
  const Scene s = touching_scene();
  const DragSystem A = coupling(s);
  const std::vector<Vec2> stir = drag_force(A, stirred(s.positions().size()));
  const std::vector<Vec2> together = drag_force(A, std::vector<Vec2>(stir.size(), Vec2(0.3, -1.0)));
  ASSERT_GT(largest(stir), 1e-3);
  EXPECT_LT(largest(together), 1e-12 * largest(stir));
}

TEST(ViscousContact, ObeysTheThirdLawAndOnlyDissipates) {
  const Scene s = touching_scene();
  const DragSystem A = coupling(s);
  const std::vector<Vec2> v = stirred(s.positions().size());
  const std::vector<Vec2> f = drag_force(A, v);
  EXPECT_LT(net_force(f).norm(), 1e-11 * largest(f));
  EXPECT_GT(power(f, v), 0.0);
  for (const double c : A.links.c) EXPECT_GE(c, 0.0);
}

TEST(ViscousContact, IsThePairDragOfTheirVolumesTimesTheSolidAndAShareOfTheFluid) {
  const std::uint32_t k = 5;
  Scene s = alone_at(9.9, k); // 4.9 um out: few segments in reach, all of them with their outer side
  s.ecm.f[k] = 0.25;
  double pair = 0.0;
  const Kernel kernel(s.p.ecm.smoothing_length);
  for (std::size_t i = 0; i < s.c.size(); ++i) {
    const Vec2 e = s.c.x[s.c.next(i)] - s.c.x[i];
    const double r = (s.c.x[i] + 0.5 * e - s.ecm.x[k]).norm();
    const double shared = std::sqrt(s.ecm.V0 * e.norm() * s.p.ecm.particle_spacing);
    pair += pair_drag(r * r, kernel.W_slope(r), shared, s.p.ecm.viscosity, 1.0, kernel.h());
  }
  ASSERT_GT(pair, 0.0);
  for (const double share : {0.0, 0.1, 1.0}) {
    s.p.contact.body_fluid_share = share;
    EXPECT_NEAR(drag_on_cell(s, {1.0, 0.0}).x(), -(0.25 + 0.75 * share) * pair, 1e-12) << share;
  }
}

TEST(ViscousContact, FluidHoldsTheCellFromOutsideOnly) {
  const std::uint32_t k = 5;
  EXPECT_LT(drag_on_cell(alone_at(6.0, k), {1.0, 0.0}).x(), 0.0);
  EXPECT_EQ(drag_on_cell(alone_at(4.0, k), {1.0, 0.0}).norm(), 0.0);
  Scene solid = alone_at(4.0, k);
  solid.ecm.f[k] = 1.0; // solid that the cortex has just passed holds it
  EXPECT_LT(drag_on_cell(solid, {1.0, 0.0}).x(), 0.0);
}

TEST(ViscousContact, FluidHoldsTheCellLessThanSolid) {
  const Scene held = touching_scene();
  Scene loose = held;
  std::fill(loose.ecm.f.begin(), loose.ecm.f.end(), 0.0);
  const double in_fluid = drag_on_cell(loose, {1.0, 0.0}).x();
  EXPECT_LT(in_fluid, 0.0);
  EXPECT_GT(in_fluid, 0.2 * drag_on_cell(held, {1.0, 0.0}).x());
  loose.p.contact.fluid_share = loose.p.contact.body_fluid_share = 0.0;
  EXPECT_EQ(drag_on_cell(loose, {1.0, 0.0}).norm(), 0.0);
}

TEST(ViscousContact, FluidHoldsGrowingProtrusionsAndTheBodyByTheirOwnShares) {
  Scene s = touching_scene();
  std::fill(s.ecm.f.begin(), s.ecm.f.end(), 0.0);
  const std::vector<std::uint8_t> all(s.c.size(), 1);
  std::vector<std::uint8_t> half = all;
  std::fill_n(half.begin(), s.c.size() / 2, 0);
  std::vector<std::uint8_t> other_half;
  for (const std::uint8_t grows : half) other_half.push_back(grows == 0 ? 1 : 0);
  const auto drag = [&](double of_tips, double of_body, const std::vector<std::uint8_t>& soft) {
    s.p.contact.fluid_share = of_tips;
    s.p.contact.body_fluid_share = of_body;
    return drag_on_cell(s, {1.0, 0.0}, soft).x();
  };
  const double whole = drag(0.2, 0.2, {});
  ASSERT_LT(whole, 0.0);
  EXPECT_DOUBLE_EQ(drag(0.2, 0.2, half), whole) << "one share for both, as before";
  EXPECT_DOUBLE_EQ(drag(0.2, 0.0, all), whole);
  EXPECT_EQ(drag(0.2, 0.0, {}), 0.0) << "a body without drag from fluid";
  EXPECT_EQ(drag(0.0, 0.2, all), 0.0);
  const double of_half = drag(0.2, 0.0, half);
  EXPECT_LT(of_half, 0.0);
  EXPECT_NEAR(of_half + drag(0.2, 0.0, other_half), whole, 1e-12) << "a share of each segment";
  EXPECT_NEAR(drag(0.2, 0.05, half), of_half + 0.25 * (whole - of_half), 1e-12);
}

TEST(ViscousContact, DoesNotDependOnHowFinelyTheSegmentsAreSampled) {
  Scene coarse = touching_scene();
  Scene fine = coarse;
  coarse.p.contact.sample_spacing = 0.8;
  fine.p.contact.sample_spacing = 0.05;
  const double f = drag_on_cell(fine, {0.0, 1.0}).y();
  EXPECT_NEAR(drag_on_cell(coarse, {0.0, 1.0}).y(), f, 0.02 * std::abs(f));
}
