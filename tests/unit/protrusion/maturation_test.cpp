#include "protrusion/maturation.hpp"

#include "scene.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(Maturation, ClimbsInTenStepsOfATenth) {
  EXPECT_DOUBLE_EQ(maturing_f_mat(0), 0.1);
  EXPECT_DOUBLE_EQ(maturing_f_mat(4), 0.5);
  EXPECT_DOUBLE_EQ(maturing_f_mat(9), 1.0);
  EXPECT_DOUBLE_EQ(maturing_f_mat(10), 1.0);
}

TEST(Maturation, AStepIsDoneAtNinetyEightPercentOfItsForce) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(step_force(0, p), 0.0588);
  EXPECT_DOUBLE_EQ(step_force(4, p), 0.4 * 0.6 + 0.98 * 0.06);
}

TEST(Maturation, EndsAtTheStepsDoneAndTheShareOfTheRunningOne) {
  const Parameters p;
  EXPECT_DOUBLE_EQ(final_f_mat(3, 0.18, p), 0.3);                   // nothing of the fourth
  EXPECT_NEAR(final_f_mat(3, 0.18 + 0.5 * 0.0588, p), 0.35, 1e-12); // half of it
  EXPECT_DOUBLE_EQ(final_f_mat(3, 5.0, p), 0.4);                    // no more than it
  EXPECT_DOUBLE_EQ(final_f_mat(3, 0.1, p), 0.3);                    // steps done are kept
  EXPECT_DOUBLE_EQ(final_f_mat(0, 0.0, p), 0.05);                   // at least the body's
  EXPECT_DOUBLE_EQ(final_f_mat(10, 0.6, p), 1.0);
}

TEST(Maturation, PullsTheCentreBackAndPinsTheBase) {
  const Parameters p = small_matrix();
  State s = cell_in_matrix(p);
  const Vec2 d = outward(s, 50);
  add_protrusion(s, 50, Maturing{d, s.cortex.x[50] + 5.0 * d, 2});
  add_protrusion(s, 150, Growing{outward(s, 150)});
  const Assembled a = assemble(s.ecm.size() + s.cortex.size(),
                               [&](std::span<Vec2> force, DragSystem& A) { add_maturation(s, p, force, A); });
  for (std::size_t i = 0; i < s.cortex.size(); ++i) {
    const Vec2 expected = i == 50 ? Vec2(-0.3 * 0.6 * d) : Vec2(0.0, 0.0);
    EXPECT_LT((a.force[s.node(i)] - expected).norm(), 1e-15);
    const bool at_base = (i >= 30 && i <= 32) || (i >= 68 && i <= 70);
    EXPECT_EQ(a.A.diagonal[s.node(i)], at_base ? 1000.0 : 0.0) << i;
  }
}
