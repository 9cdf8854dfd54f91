#include "simulation/march.hpp"

#include "base/failure.hpp"
#include "gel.hpp"
#include "simulation/step_limits.hpp"
#include "sph/interpolate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace matrigrate;

TEST(March, RefusesAStepBeyondTheLimitAndNamesIt) {
  Parameters p = small();
  p.run.time_step = 3.0;
  State s = start(p);
  Workspace w(s, p);
  try {
    march(s, p, w, 100.0);
    FAIL() << "no failure was reported";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("elasticity of the intact matrix"), std::string::npos) << failure.what();
  }
  EXPECT_EQ(s.step, 0U);
}

TEST(March, EndsWhereItShould) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  march(s, p, w, 4.0);
  EXPECT_EQ(s.step, 10U);
  int seen = 0;
  march(s, p, w, 100.0, {}, [&](const State&) { return ++seen < 3; });
  EXPECT_EQ(s.step, 13U);
}

TEST(AdaptiveStep, MeetsTheMultiplesOfTheLongestStepAndHalvesWhereThingsMoveFar) {
  Parameters p = small();
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 2.0;
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State& at, std::span<Vec2> force) { // strong for a while
    const double pull = at.t > 9.0 && at.t < 11.0 ? 3.0 : 0.01;
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(pull, 0.0), force);
  };
  std::vector<double> times;
  double longest_move = 0.0;
  double shortest = p.run.time_step;
  std::vector<Vec2> x = s.ecm.x;
  march(s, p, w, 40.0, load, [&](const State& now) {
    shortest = std::min(shortest, now.t - (times.empty() ? 0.0 : times.back()));
    times.push_back(now.t);
    for (std::size_t i = 0; i < x.size(); ++i) longest_move = std::max(longest_move, (now.ecm.x[i] - x[i]).norm());
    x = now.ecm.x;
    return true;
  });
  for (int k = 1; k <= 20; ++k) EXPECT_TRUE(std::ranges::count(times, 2.0 * k) == 1) << k;
  EXPECT_GT(times.size(), 20U);
  EXPECT_LT(times.size(), 40U);
  EXPECT_LT(shortest, 1.5);
  EXPECT_LE(longest_move, 0.2 * p.ecm.particle_spacing * (1.0 + 1e-9));
}

TEST(March, EndsWithinAStepExactlyWhereItShould) {
  for (const Integrator integrator : {Integrator::reference, Integrator::adaptive})
    for (const double t_end : {41.0, 40.0 + 1e-4, 39.9}) {
      Parameters p = small();
      p.run.integrator = integrator;
      if (integrator == Integrator::adaptive) p.run.time_step = 2.0;
      State s = start(p);
      Workspace w(s, p);
      const auto go_on = [](const State& /*now*/) { return true; };
      EXPECT_TRUE(march_within(s, p, w, t_end, go_on));
      EXPECT_LE(s.t, t_end);
      State longer = start(p); // goes on with the same bits
      Workspace w_longer(longer, p);
      march(longer, p, w_longer, s.t);
      EXPECT_TRUE(same_bits(s, longer));
      const std::uint64_t steps = s.step;
      const double before = s.t;
      EXPECT_EQ(is_before(s, p, t_end), is_within_step(t_end, p));
      shorten_last_step(s, p, w, t_end);
      EXPECT_EQ(s.t, t_end);
      EXPECT_EQ(s.step, steps + 1);
      EXPECT_LT(s.t - before, p.run.time_step);
    }
}

TEST(March, TellsWhetherAnotherStepHasRoom) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  EXPECT_FALSE(march_within(s, p, w, 4.0, [](const State& now) { return now.step < 3; }));
  EXPECT_TRUE(march_within(s, p, w, 4.0, [](const State& now) { return now.step < 10; }));
  EXPECT_FALSE(is_before(s, p, 4.0));
  EXPECT_FALSE(is_within_step(4.0, p));
}
