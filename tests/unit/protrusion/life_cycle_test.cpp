#include "protrusion/life_cycle.hpp"

#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/maturation.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

namespace {

const Vec2 d(1.0, 0.0);
const Vec2 site(20.0, 1.0);

/// A quiet moment: solid all around, no force, no bad luck.
Circumstances quiet(double age) { return {.age = age, .force = 0.0, .support = 1.0, .ahead = site, .draw = 0.999999}; }

Transition transition(const Phase& phase, const Circumstances& now, const Parameters& p, double dt) {
  return matrigrate::transition(phase, now, p, dt, Laws(p));
}

template <class Next>
Next expect_to(const Transition& change, EndCause cause = EndCause::none) {
  EXPECT_TRUE(change.changes);
  EXPECT_FALSE(change.ends);
  EXPECT_EQ(change.cause, cause);
  EXPECT_TRUE(std::holds_alternative<Next>(change.next)) << name(change.next);
  return std::holds_alternative<Next>(change.next) ? std::get<Next>(change.next) : Next{};
}

} // namespace

TEST(Transition, GrowthLastsTProtAndThenAdheresAhead) {
  const Parameters p;
  EXPECT_FALSE(transition(Growing{d}, quiet(399.7), p, time_step).changes);
  const auto next = expect_to<Maturing>(transition(Growing{d}, quiet(400.0), p, time_step));
  EXPECT_EQ(next.anchor, site);
  EXPECT_EQ(next.direction, d);
  EXPECT_EQ(next.steps, 0);
}

TEST(Transition, GrowthThatFindsNoSolidStaysUnadhered) {
  const Parameters p;
  Circumstances now = quiet(400.0);
  now.support = 0.019;
  EXPECT_EQ(expect_to<Finishing>(transition(Growing{d}, now, p, time_step), EndCause::unadhered).f_mat, 0.05);
  now.age = 100.0; // solid does not matter before
  EXPECT_FALSE(transition(Growing{d}, now, p, time_step).changes);
}

TEST(Transition, MaturationGoesOnStepByStepAsTheForceAllows) {
  const Parameters p;
  Circumstances now = quiet(10.0);
  now.force = 0.9 * step_force({.steps = 2}, Laws(p));
  EXPECT_FALSE(transition(Maturing{d, site, 2}, now, p, time_step).changes);
  now.force = step_force({.steps = 2}, Laws(p));
  const auto next = expect_to<Maturing>(transition(Maturing{d, site, 2}, now, p, time_step));
  EXPECT_EQ(next.steps, 3);
  EXPECT_EQ(next.anchor, site);
  now.force = 10.0;
  EXPECT_FALSE(transition(Maturing{d, site, max_maturation_steps}, now, p, time_step).changes);
}

TEST(Transition, AMaturationStepCountsFromWhenItsForceWasReached) {
  const Parameters p;
  Circumstances now = quiet(100.0);
  now.loading = 0.001;
  now.force = step_force({.steps = 2}, Laws(p)) + 0.002;
  const Transition change = transition(Maturing{d, site, 2}, now, p, 5.0);
  EXPECT_NEAR(change.waited, 2.0, 1e-9);
  EXPECT_NEAR(expect_to<Maturing>(change).last_step, 98.0, 1e-9);
}

TEST(Transition, PhasesEndAsEarlyAsLate) {
  const Parameters p;
  EXPECT_FALSE(transition(Growing{d}, quiet(397.0), p, 5.0).changes);
  EXPECT_TRUE(transition(Growing{d}, quiet(398.0), p, 5.0).changes);
  EXPECT_FALSE(transition(Maturing{d, site, 4, 500.0}, quiet(597.0), p, 5.0).changes);
  expect_to<Contracting>(transition(Maturing{d, site, 4, 500.0}, quiet(598.0), p, 5.0));
  EXPECT_FALSE(transition(Finishing{0.7}, quiet(397.0), p, 5.0).changes);
  EXPECT_TRUE(transition(Finishing{0.7}, quiet(398.0), p, 5.0).ends);
}

TEST(Transition, TheSpeedOfRecoilIsThatOfTheTipTowardsItsBase) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 50, Maturing{.direction = outward(s, 50), .anchor = 1.2 * s.cell.cortex.x[50]});
  s.cell.cortex.v[50] = -0.02 * outward(s, 50) + 0.5 * perpendicular(outward(s, 50));
  const Circumstances now =
      circumstances(s.cell, s.cell.protrusions[0], s.ecm, {.step = 1, .t = 0.4}, p, time_step, Laws(p));
  EXPECT_NEAR(now.recoil, 0.02, 1e-15);
}

TEST(Transition, MaturationEndsAfterTMatWithItsFMat) {
  const Parameters p;
  Circumstances now = quiet(600.0);
  now.force = 0.27;
  const auto next = expect_to<Contracting>(transition(Maturing{d, site, 4, 500.0}, now, p, time_step)); // 125 s a step
  EXPECT_DOUBLE_EQ(next.f_mat, 0.48);
  EXPECT_EQ(next.anchor, site);
}

TEST(Transition, HandsOverToABundle) {
  const Parameters p;
  Maturing mature{d, site, 4};
  mature.last_step = 500.0; // 125 s a step, 100 s of the fifth
  Circumstances now = quiet(600.0);
  now.force = 0.25;
  const auto next = expect_to<Contracting>(transition(mature, now, p, time_step));
  EXPECT_DOUBLE_EQ(next.f_mat, 0.48);
  EXPECT_DOUBLE_EQ(next.bundle, 0.9 * 0.48 * 0.6);
  EXPECT_EQ(next.falling, 0.25);
  now = quiet(1.0);
  now.force = next.f_mat * 0.6;
  EXPECT_LT(expect_to<Contracting>(transition(next, now, p, time_step)).bundle, next.bundle);
}

TEST(Transition, AnAdhesionWhoseSolidIsGoneIsLost) {
  const Parameters p;
  Circumstances now = quiet(10.0);
  now.support = 0.0;
  expect_to<Finishing>(transition(Maturing{d, site, 4}, now, p, time_step), EndCause::lost);
  EXPECT_EQ(expect_to<Finishing>(transition(Contracting{site, 0.7}, now, p, time_step), EndCause::lost).f_mat, 0.7);
}

TEST(Transition, ContractionEndsByADrawAgainstEquationSeven) {
  const Parameters p;
  Circumstances now = quiet(10.0);
  now.force = 0.05;
  const double probability = -std::expm1(-Laws(p).disassembly_rate({0.05, 0.7, 10.0}) * time_step);
  now.draw = 1.0001 * probability;
  EXPECT_FALSE(transition(Contracting{site, 0.7}, now, p, time_step).changes);
  now.draw = 0.9999 * probability;
  EXPECT_EQ(expect_to<Finishing>(transition(Contracting{site, 0.7}, now, p, time_step), EndCause::disassembly).f_mat,
            0.7);
}

TEST(Transition, RuptureIsCertainAboveItsForce) {
  Parameters p;
  p.adhesion.rupture = true;
  Circumstances now = quiet(10.0);
  now.force = 0.85; // 0.7 x 0.6 nN in each of two strands is 0.84
  expect_to<Finishing>(transition(Contracting{site, 0.7}, now, p, time_step), EndCause::rupture);
  // while the bundle still pulls, it gives way instead
  EXPECT_LT(expect_to<Contracting>(transition(Contracting{site, 0.7, 0.1}, now, p, time_step)).bundle, 0.1);
  p.adhesion.rupture = false;
  EXPECT_FALSE(transition(Contracting{site, 0.7}, now, p, time_step).changes);
}

TEST(Transition, FinishingLastsTFinishAndFreesTheParticles) {
  const Parameters p;
  EXPECT_FALSE(transition(Finishing{0.7}, quiet(399.7), p, time_step).changes);
  EXPECT_TRUE(transition(Finishing{0.7}, quiet(400.0), p, time_step).ends);
}

TEST(Circumstances, TellTheForceTheSolidAheadAndADrawOfItsOwn) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  s.now.t = 400.0;
  Protrusion& growing = add_protrusion(s, 0, Growing{d});
  growing.since = 0.0;
  Circumstances now = circumstances(s.cell, s.cell.protrusions[0], s.ecm, s.now, p, time_step, Laws(p));
  EXPECT_NEAR(now.age, 400.0, 1e-5);
  EXPECT_GE(now.age, 400.0);
  EXPECT_LT((now.ahead - Vec2(20.0, 0.0)).norm(), 1e-9);
  EXPECT_GT(now.support, 0.5);
  EXPECT_EQ(now.force, 0.0);
  s.cell.protrusions[0].phase = Contracting{s.cell.cortex.x[0] + Vec2(5.2, 0.0), 1.0};
  const Circumstances then = circumstances(s.cell, s.cell.protrusions[0], s.ecm, s.now, p, time_step, Laws(p));
  EXPECT_NEAR(then.force, 0.4, 1e-9);
  EXPECT_EQ(then.draw, now.draw); // same step, same protrusion
  s.cell.protrusions[0].record.id = 2;
  EXPECT_NE(circumstances(s.cell, s.cell.protrusions[0], s.ecm, s.now, p, time_step, Laws(p)).draw, now.draw);
}

TEST(UpdateProtrusions, WritesDownTheWholeLifeOfAProtrusion) {
  Parameters p = small_matrix();
  p.adhesion.r_off_min = 10.0; // disassembles at once when it contracts
  Scene s = cell_in_matrix(p);
  const Vec2 direction = outward(s, 100);
  add_protrusion(s, 100, Growing{direction});
  for (std::size_t i = 95; i <= 105; ++i) s.cell.cortex.x[i] *= 1.2;
  const Laws laws(p);
  const auto until = [&](double t) {
    while (s.now.t < t - 0.5 * time_step) {
      ++s.now.step;
      s.now.t = static_cast<double>(s.now.step) * time_step;
      update_protrusions(s.cell, s.ecm, s.now, p, time_step, laws);
    }
  };
  const double stretched = (s.cell.cortex.x[95] - s.cell.cortex.x[94]).norm();
  until(399.6);
  EXPECT_NE(s.cell.cortex.l0[94], stretched);
  until(400.0);
  ASSERT_TRUE(std::holds_alternative<Maturing>(s.cell.protrusions.at(0).phase));
  EXPECT_EQ(s.cell.cortex.l0[94], stretched); // rest lengths are taken anew
  EXPECT_NEAR(s.cell.protrusions[0].record.t_adhesion, 400.0, 1e-9);
  EXPECT_NEAR(s.cell.protrusions[0].record.direction, std::atan2(direction.y(), direction.x()), 1e-12);
  EXPECT_EQ(s.cell.protrusions[0].record.length, protrusion_length(s.cell.cortex, 100, p.protrusion));
  std::get<Maturing>(s.cell.protrusions[0].phase).anchor += 0.05 * outward(s, 100); // 0.1 nN
  until(1000.4); // the first step waited for rest, a step of 0.4 s that does not count
  ASSERT_TRUE(std::holds_alternative<Contracting>(s.cell.protrusions.at(0).phase));
  EXPECT_NEAR(s.cell.protrusions[0].record.t_mature, 1000.4, 1e-9);
  EXPECT_NEAR(s.cell.protrusions[0].record.f_mat, 0.2, 1e-12); // one early step: the running one counts as done
  until(1002.0);
  ASSERT_TRUE(std::holds_alternative<Finishing>(s.cell.protrusions.at(0).phase));
  const ProtrusionRecord record = s.cell.protrusions[0].record;
  EXPECT_EQ(record.cause, EndCause::disassembly);
  EXPECT_NEAR(record.force, 0.1, 1e-9);
  until(record.t_disassembly + 400.0);
  EXPECT_TRUE(s.cell.protrusions.empty());
  ASSERT_EQ(s.cell.ended.size(), 1U);
  EXPECT_NEAR(s.cell.ended[0].t_end, record.t_disassembly + 400.0, 1e-9);
}
