#include "protrusion/maturation.hpp"

#include "scene.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

constexpr double a_step = 0.4; // [s]

} // namespace

TEST(Maturation, ClimbsInTenStepsOfATenth) {
  EXPECT_DOUBLE_EQ(maturing_f_mat(0, Laws({})), 0.1);
  EXPECT_DOUBLE_EQ(maturing_f_mat(4, Laws({})), 0.5);
  EXPECT_DOUBLE_EQ(maturing_f_mat(9, Laws({})), 1.0);
  EXPECT_DOUBLE_EQ(maturing_f_mat(10, Laws({})), 1.0);
}

TEST(Maturation, AStepIsDoneAtNinetyEightPercentOfItsForce) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(step_force({.steps = 0}, Laws(p)), 0.0588);
  EXPECT_DOUBLE_EQ(step_force({.steps = 4}, Laws(p)), 0.4 * 0.6 + 0.98 * 0.06);
}

TEST(Maturation, PullsWithAsManyStrandsAsAsked) {
  Parameters p;
  p.adhesion.maturation_strands = 1.5;
  EXPECT_DOUBLE_EQ(step_force({.steps = 4}, Laws(p)), 1.5 * (0.4 * 0.6 + 0.98 * 0.06));
  p = small_matrix();
  p.adhesion.maturation_strands = 2.0;
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 50, Maturing{.direction = {1.0, 0.0}, .anchor = 2.0 * s.cell.cortex.x[50], .steps = 2});
  const Assembled a = assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
    add_maturation(s.cell, p, Laws(p), {}, a_step, s.first(), force, A);
  });
  EXPECT_NEAR(a.force[s.node(50)].x(), -2.0 * 0.3 * 0.6, 1e-12);
}

TEST(Maturation, PinsAsManyParticlesOfTheBaseAsAsked) {
  for (const int pinned : {1, 3, 7}) {
    Parameters p = small_matrix();
    p.adhesion.pinned_particles = pinned;
    Scene s = cell_in_matrix(p);
    add_protrusion(s, 50, Maturing{.direction = {1.0, 0.0}, .anchor = 2.0 * s.cell.cortex.x[50]});
    const Assembled a = assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
      add_maturation(s.cell, p, Laws(p), {}, a_step, s.first(), force, A);
      pin_bases(s.cell, p, s.first(), A);
    });
    for (std::size_t i = 0; i < s.cell.cortex.size(); ++i) {
      const bool on_base = (i >= 30 && i < 30U + pinned) || (i <= 70 && i > 70U - pinned);
      EXPECT_EQ(a.A.diagonal[s.node(i)], on_base ? p.adhesion.base_drag : 0.0) << pinned << " " << i;
    }
  }
}

TEST(Maturation, TheFirstStepWaitsUntilTheRecoilOfGrowthIsOver) {
  Parameters p;
  p.adhesion.rest_speed = 0.004;
  EXPECT_FALSE(step_done({.steps = 0, .force = 0.06, .recoil = 0.0041}, p, Laws(p)))
      << "tip and matrix still spring back together";
  EXPECT_TRUE(step_done({.steps = 0, .force = 0.06, .recoil = 0.0039}, p, Laws(p)));
  EXPECT_FALSE(step_done({.steps = 0, .force = 0.05, .recoil = 0.0}, p, Laws(p)))
      << "the adhesion does not bear the step yet";
  EXPECT_TRUE(step_done({.steps = 1, .force = 0.12, .recoil = 0.1}, p, Laws(p)))
      << "later steps count by their force alone";
  EXPECT_FALSE(step_done({.steps = max_maturation_steps, .force = 1.0, .recoil = 0.0}, p, Laws(p)));
  p.adhesion.rest_speed = 0.0;
  EXPECT_TRUE(step_done({.steps = 0, .force = 0.06, .recoil = 10.0}, p, Laws(p))) << "at any speed";
}

TEST(Maturation, TellsHowLongAgoAStepWasDone) {
  const Parameters p;
  const Laws laws(p);
  const double F = step_force({.steps = 2}, laws);
  const auto since_done = [&](int steps, double force, double loading) {
    return time_since_done({.steps = steps, .force = force, .loading = loading}, 5.0, laws);
  };
  EXPECT_DOUBLE_EQ(since_done(2, F, 0.001), 0.0);
  EXPECT_NEAR(since_done(2, F + 0.003, 0.001), 3.0, 1e-12);
  EXPECT_EQ(since_done(2, F + 0.006, 0.001), 0.0) << "it was not the force that it waited for";
  EXPECT_EQ(since_done(2, F + 0.003, -0.001), 0.0);
  EXPECT_EQ(since_done(0, 0.07, 0.001), 5.0) << "the first one waited for rest";
  EXPECT_NEAR(since_done(0, step_force({.steps = 0}, Laws(p)) + 0.003, 0.001), 3.0, 1e-12);
}

TEST(Maturation, EndsAtTheStepsDoneAndTheShareOfTheRunningOneByTime) {
  const Parameters p; // T_mat = 600 s
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 3, .force = 0.0}, 450.0, p, Laws(p)),
                   0.4); // 150 s a step: the paper's 0.1 x 600/150
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 3, .force = 0.0}, 525.0, p, Laws(p)),
                   0.1 * (3.0 + 75.0 / 175.0)); // 0.1 x 600/175
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 2, .force = 0.0}, 364.0, p, Laws(p)),
                   0.3); // the next one took longer: it counts as one
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 1, .force = 0.0}, 5.0, p, Laws(p)), 0.2); // and so after a single early step
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 0, .force = 0.0294}, 0.0, p, Laws(p)),
                   0.05);                                                           // without a step: half of its force
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 0, .force = 0.0}, 0.0, p, Laws(p)), 0.05); // at least the body's
  EXPECT_DOUBLE_EQ(final_f_mat({.steps = 10, .force = 0.6}, 500.0, p, Laws(p)), 1.0);
}

TEST(Handover, TheBundlePullsTipAndBaseTogetherWithoutAResultant) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  for (std::size_t i = 45; i <= 55; ++i) s.cell.cortex.x[i] *= 1.5;
  add_protrusion(s, 50, Contracting{2.0 * s.cell.cortex.x[50], 0.5, 0.2});
  const Assembled a = assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
    add_maturation(s.cell, p, Laws(p), {}, a_step, s.first(), force, A);
  });
  EXPECT_LT(net_force(a.force).norm(), 1e-15);
  EXPECT_NEAR(a.force[s.node(30)].norm(), 0.1, 1e-12);
  EXPECT_NEAR(a.force[s.node(70)].norm(), 0.1, 1e-12);
  EXPECT_LT(a.force[s.node(50)].dot(outward(s, 50)), 0.0);
  ASSERT_EQ(a.A.directed.size(), 2U); // a side each, across it
  EXPECT_NEAR(a.A.directed.c[0], a_step * 0.1 / (s.cell.cortex.x[30] - s.cell.cortex.x[50]).norm(), 1e-12);
}

TEST(Handover, TheBundleGivesWayByTheLoadBeyondNineTenthsOfThePull) {
  const Parameters p;
  constexpr double dt = 40.0; // all of the excess
  const auto left = [&](double F) { return handed_over(Contracting{Vec2::Zero(), 0.5, 0.2}, F, p, dt).bundle; };
  EXPECT_DOUBLE_EQ(left(0.26), 0.2); // 0.27 nN are allowed
  EXPECT_DOUBLE_EQ(left(0.32), 0.2 - 0.05);
  EXPECT_EQ(left(0.9), 0.0);
}

TEST(Handover, TheBundleGivesWayAsFastWhateverTheStep) {
  const auto after = [](double dt) {
    const Parameters p;
    Contracting phase{Vec2::Zero(), 0.5, 10.0};
    for (double t = 0.5 * dt; t < 1.2; t += dt) phase = handed_over(phase, 0.28, p, dt);
    return phase.bundle;
  };
  // of an excess that stays the bundle loses a share 1 - exp(-dt/0.4 s) a step: a rate of 1/0.4 s for short steps
  EXPECT_NEAR(10.0 - after(0.025), 0.01 * 1.2 / 0.4, 0.002);
  EXPECT_NEAR(10.0 - after(0.05), 10.0 - after(0.025), 0.002);
}

TEST(Handover, WhatMaturationLoadedFallsOffFirst) {
  const Parameters p;
  Contracting phase = handover(Maturing{}, 0.5, 0.33, p); // the running step had loaded a tenth more than 0.3 nN
  const double whole = phase.bundle;
  EXPECT_DOUBLE_EQ(whole, 0.27);
  for (const double F : {0.32, 0.30, 0.28, 0.275}) {
    phase = handed_over(phase, F, p, a_step);
    EXPECT_EQ(phase.bundle, whole) << F;
    EXPECT_EQ(phase.falling, F);
  }
  phase = handed_over(phase, 0.26, p, a_step);
  EXPECT_EQ(phase.falling, 0.0);
  EXPECT_EQ(phase.bundle, whole);
  EXPECT_LT(handed_over(phase, 0.28, p, a_step).bundle, whole); // now the cortex pulls
  Contracting held = handover(Maturing{}, 0.5, 0.33, p);        // others pull: the load does not fall
  held = handed_over(held, 0.34, p, a_step);
  EXPECT_LT(held.bundle, whole);
}

TEST(Handover, TakesItsShareAndItsTimeFromTheScenario) {
  Parameters p;
  p.adhesion.handover_share = 0.5;
  p.adhesion.handover_time = 2.0;
  const Contracting phase = handover(Maturing{.held = Vec2(3.0, 4.0)}, 0.5, 0.15, p);
  EXPECT_DOUBLE_EQ(phase.bundle, 0.15);
  EXPECT_EQ(phase.held, Vec2(3.0, 4.0));
  const Contracting later = handed_over(handed_over(phase, 0.15, p, a_step), 0.2, p, a_step);
  EXPECT_DOUBLE_EQ(later.bundle, 0.15 + std::expm1(-a_step / 2.0) * 0.05);
}

TEST(Maturation, PullsTheCentreBackAndPinsTheBase) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const Vec2 d = outward(s, 50);
  add_protrusion(s, 50, Maturing{d, s.cell.cortex.x[50] + 5.0 * d, 2});
  add_protrusion(s, 150, Growing{outward(s, 150)});
  const Assembled a = assemble(s.nodes(), [&](std::span<Vec2> force, DragSystem& A) {
    add_maturation(s.cell, p, Laws(p), {}, a_step, s.first(), force, A);
    pin_bases(s.cell, p, s.first(), A);
  });
  for (std::size_t i = 0; i < s.cell.cortex.size(); ++i) {
    const Vec2 expected = i == 50 ? Vec2(-0.3 * 0.6 * d) : Vec2(0.0, 0.0);
    EXPECT_LT((a.force[s.node(i)] - expected).norm(), 1e-15);
    const bool at_base = (i >= 30 && i <= 32) || (i >= 68 && i <= 70);
    EXPECT_EQ(a.A.diagonal[s.node(i)], at_base ? 1000.0 : 0.0) << i;
  }
}
