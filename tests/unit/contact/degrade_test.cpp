#include "contact/degrade.hpp"

#include "contact/elastic.hpp"
#include "ecm/law/material.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace matrigrate;

TEST(Degradation, FollowsALawOfTheUsers) {
  Parameters p;
  p.laws.degradation_body = "0.1*f + p/1000";
  p.laws.degradation_protrusion = "0.3";
  const Laws laws(p);
  const Degradable half{.distance = 1.5, .solid_pressure = 0.05, .f = 0.5};
  EXPECT_NEAR(degradation_rate(half, p, laws.degradation_body), 0.05 + 0.05, 1e-12) << "50 Pa";
  EXPECT_EQ(degradation_rate(half, p, laws.degradation_protrusion), 0.3);
}

namespace {

/// The rate of the paper within the reach of protrusion or body.
double rate_at(double distance, bool on_protrusion, double solid_pressure, const Parameters& p) {
  const Laws laws(p);
  return degradation_rate({distance, solid_pressure}, p,
                          on_protrusion ? laws.degradation_protrusion : laws.degradation_body);
}

/// What a particle of the matrix in a scene, a distance from a segment and pressed, has lost after a step.
double lost_at(double distance, bool on_protrusion, const Parameters& p) {
  Scene s = touching_scene();
  s.p = p;
  NearbyParticle near = s.nearby().front();
  near.distance = distance;
  s.ecm.f[near.particle] = 1.0;
  s.ecm.rho[near.particle] *= 2.0; // is pressed
  degrade(s.ecm, p, std::array{near}, {std::vector<std::uint8_t>(s.c.size(), on_protrusion ? 1 : 0)}, {}, 0.4, Laws(p));
  return 1.0 - s.ecm.f[near.particle];
}

} // namespace

TEST(Degrade, HasItsReachOnProtrusionAndBody) {
  Parameters p;
  p.degradation.protrusion_rate = 0.01;
  p.degradation.body_rate = 0.02;
  EXPECT_NEAR(lost_at(1.39, true, p), 0.4 * 0.01, 1e-15);
  EXPECT_EQ(lost_at(1.4, true, p), 0.0);
  EXPECT_NEAR(lost_at(1.89, false, p), 0.4 * 0.02, 1e-15);
  EXPECT_EQ(lost_at(1.9, false, p), 0.0);
}

TEST(DegradationRate, NeedsPressureOfTheSolidOrOfTheContactWhereAsked) {
  Parameters p;
  p.degradation.smaller_share = 0.0;
  EXPECT_EQ(rate_at(1.5, false, 0.0, p), 0.0);
  EXPECT_EQ(rate_at(1.5, false, p.degradation.threshold, p), 0.0);
  EXPECT_GT(rate_at(1.5, false, 1.001 * p.degradation.threshold, p), 0.0);
  // contact alone reaches the threshold at d_c (1 - p_th/K)
  const double d = p.contact.range * (1.0 - p.degradation.threshold / moduli(p.ecm).K);
  EXPECT_GT(rate_at(d - 1e-6, false, -1.0, p), 0.0);
  EXPECT_EQ(rate_at(d + 1e-6, false, -1.0, p), 0.0);
}

TEST(DegradationRate, AddsThePressuresOfSolidAndContact) {
  const Parameters p;
  const double distance = 1.36; // the contact gives 0.95 of the threshold
  const double of_contact = contact_pressure(distance, p);
  ASSERT_LT(of_contact, p.degradation.threshold);
  const double rest = p.degradation.threshold - of_contact;
  EXPECT_DOUBLE_EQ(degradation_pressure(distance, rest, p), p.degradation.threshold);
  EXPECT_GT(rate_at(distance, true, 1.001 * rest, p), 0.0);
  EXPECT_EQ(rate_at(distance, true, 0.999 * rest, p), 0.0);
  EXPECT_EQ(rate_at(distance, true, -of_contact, p), 0.0) << "a solid under tension bears part of the contact";
}

TEST(DegradationRate, WeighsTheSmallerPressureBetweenTheSumAndTheLarger) {
  Parameters sum;
  for (const double distance : {0.5, 1.36, 1.5})
    for (const double of_solid : {-0.01, 0.0, 0.015, 0.7}) {
      const double of_contact = contact_pressure(distance, sum);
      sum.degradation.smaller_share = 1.0;
      EXPECT_EQ(degradation_pressure(distance, of_solid, sum), of_solid + of_contact) << "in every bit";
      sum.degradation.smaller_share = 0.0;
      EXPECT_EQ(degradation_pressure(distance, of_solid, sum), std::max(of_solid, of_contact));
      sum.degradation.smaller_share = 0.25;
      EXPECT_DOUBLE_EQ(degradation_pressure(distance, of_solid, sum),
                       std::max(of_solid, of_contact) + 0.25 * std::min(of_solid, of_contact));
    }
}

TEST(Degrade, FollowsTheRateOfEachNearbyParticleAndLeavesTheRestAlone) {
  Scene s = touching_scene();
  const EcmState before = s.ecm;
  const std::vector<NearbyParticle> nearby = s.nearby();
  std::vector<std::uint8_t> on_protrusion(s.c.size(), 0);
  for (std::size_t i = 0; i < 12; ++i) on_protrusion[i] = 1;
  s.p.degradation.protrusion_rate = 0.011;
  s.p.degradation.smaller_share = 0.0; // the contact alone presses
  degrade(s.ecm, s.p, nearby, {on_protrusion}, {}, 0.4, Laws(s.p));
  std::vector<double> expected = before.f;
  for (const NearbyParticle& e : nearby)
    expected[e.particle] -= 0.4
                            * (e.distance < (on_protrusion[e.segment] != 0 ? 1.4 : 1.9)
                                   ? rate_at(e.distance, on_protrusion[e.segment] != 0, 0.0, s.p)
                                   : 0.0);
  int changed = 0;
  for (std::size_t k = 0; k < s.ecm.size(); ++k) {
    EXPECT_NEAR(s.ecm.f[k], expected[k], 1e-15);
    if (s.ecm.f[k] < before.f[k]) ++changed;
  }
  EXPECT_GT(changed, 5);
}

TEST(Degrade, WorksMoreSlowlyAroundTheRearOfTheBodyWhereAsked) {
  Scene s = touching_scene();
  const EcmState before = s.ecm;
  const std::vector<NearbyParticle> nearby = s.nearby();
  std::vector<std::uint8_t> on_protrusion(s.c.size(), 0), of_front(s.c.size(), 0);
  for (std::size_t i = 0; i < s.c.size(); ++i) {
    on_protrusion[i] = i % 4 == 0 ? 1 : 0;
    of_front[i] = i < s.c.size() / 2 ? 1 : 0;
  }
  s.p.degradation.rear_share = 0.25;
  degrade(s.ecm, s.p, nearby, {on_protrusion, of_front}, {}, 0.4, Laws(s.p));
  int rear = 0;
  for (const NearbyParticle& e : nearby) {
    const double usual = 0.4
                         * (e.distance < (on_protrusion[e.segment] != 0 ? 1.4 : 1.9)
                                ? rate_at(e.distance, on_protrusion[e.segment] != 0, 0.0, s.p)
                                : 0.0);
    const bool slow = on_protrusion[e.segment] == 0 && of_front[e.segment] == 0;
    EXPECT_NEAR(before.f[e.particle] - s.ecm.f[e.particle], (slow ? 0.25 : 1.0) * usual, 1e-15);
    if (slow && usual > 0.0) ++rear;
  }
  EXPECT_GT(rear, 2);
}

TEST(Degrade, WorksAtATipWhateverThePressureAndTheFasterRateCounts) {
  Scene s = touching_scene();
  const Vec2 tip = s.c.x[0];
  const std::vector<std::uint8_t> on_protrusion(s.c.size(), 0);
  const EcmState before = s.ecm;
  degrade(s.ecm, s.p, s.nearby(), {on_protrusion}, std::vector<Vec2>{tip, tip}, 0.4, Laws(s.p));
  int at_tip = 0;
  for (std::size_t k = 0; k < s.ecm.size(); ++k) {
    if ((s.ecm.x[k] - tip).norm() >= 2.4 || s.ecm.clamped[k]) continue;
    EXPECT_NEAR(before.f[k] - s.ecm.f[k], 0.08, 1e-12);
    ++at_tip;
  }
  EXPECT_GT(at_tip, 1);
}

TEST(Degrade, TakesTipsAndParticlesWhereTheyAreInTheMiddleOfTheStep) {
  Scene rest = touching_scene();
  const Vec2 tip = rest.c.x[0];
  const std::vector<std::uint8_t> on_protrusion(rest.c.size(), 0);
  const auto nearby = rest.nearby();
  Scene moving = rest;
  const Vec2 v(4.0, -3.0);
  const double dt = 0.4;
  for (std::size_t k = 0; k < moving.ecm.size(); ++k) {
    moving.ecm.v[k] = v;
    moving.ecm.x[k] += dt * v;
  }
  degrade(rest.ecm, rest.p, nearby, {on_protrusion}, std::vector<Vec2>{tip}, dt, Laws(rest.p));
  degrade(moving.ecm, moving.p, nearby, {on_protrusion}, std::vector<Vec2>{tip + 0.5 * dt * v}, dt, Laws(moving.p));
  EXPECT_EQ(moving.ecm.f, rest.ecm.f);
  EXPECT_LT(std::ranges::min(rest.ecm.f), 1.0);
}

TEST(Degrade, TurnsAParticleIntoFluidInThirtySecondsAtTheBody) {
  Scene s = touching_scene();
  for (double& f : s.ecm.f) f = 1.0;
  s.p.degradation.smaller_share = 0.0;
  const std::vector<NearbyParticle> nearby = s.nearby();
  const auto close =
      std::ranges::find_if(nearby, [](const NearbyParticle& e) { return e.distance > 0.0 && e.distance < 1.0; });
  ASSERT_NE(close, nearby.end());
  const std::uint32_t k = close->particle;
  s.ecm.S[k](0, 1) = 0.01;
  int steps = 0;
  for (; s.ecm.f[k] > 0.0 && steps < 1000; ++steps)
    degrade(s.ecm, s.p, nearby, {std::vector<std::uint8_t>(s.c.size(), 0)}, {}, 0.4, Laws(s.p));
  EXPECT_NEAR(0.4 * steps, 1.0 / 0.033, 0.41);
  EXPECT_EQ(s.ecm.S[k].norm(), 0.0);
}

TEST(FluidizeEngulfed, TakesWhatLiesDeepInsideTheCell) {
  Scene s = touching_scene();
  const std::vector<NearbyParticle> nearby = s.nearby();
  const auto deep = static_cast<std::size_t>(
      std::ranges::count_if(nearby, [](const NearbyParticle& e) { return e.distance < -0.3; }));
  ASSERT_GT(deep, 0U);
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, nearby), deep);
  EXPECT_EQ(fluidize_engulfed(s.ecm, s.p, nearby), 0U);
  for (const NearbyParticle& e : nearby) EXPECT_EQ(s.ecm.f[e.particle] > 0.0, e.distance >= -0.3);
}
