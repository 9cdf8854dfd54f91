#include "observe/reaction.hpp"

#include "simulation/advance.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(ClampForce, BalancesTheLoad) {
  Parameters p;
  p.solver.tolerance = 1e-10;
  State s;
  s.ecm = strip(p.ecm, 24.0, 30.0);
  Workspace w(s, p);
  Vec2 total = Vec2::Zero();
  const Loads load = [&](const State& at, std::span<Vec2> force) {
    total.setZero();
    for (std::size_t i = 0; i < at.ecm.size(); ++i)
      if (!at.ecm.clamped[i]) {
        force[i] += Vec2(1e-4, 2e-4);
        total += Vec2(1e-4, 2e-4);
      }
  };
  for (int k = 0; k < 20; ++k) advance(s, p, p.run.time_step, w, load);
  // drag is read after the move of the last step: equal up to a displacement of 1e-3 um against a spacing of 2 um
  const Vec2 force = clamp_force(s, p, w, [](const Vec2&) { return true; });
  EXPECT_NEAR((force + total).norm(), 0.0, 1e-3 * total.norm());
  const Vec2 top = clamp_force(s, p, w, [](const Vec2& X) { return X.y() > 0.0; });
  EXPECT_NEAR((top - 0.5 * force).norm(), 0.0, 1e-3 * total.norm());
}
