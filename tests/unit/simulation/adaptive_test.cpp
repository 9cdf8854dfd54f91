#include "simulation/adaptive.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

constexpr StepLimits long_enough{.elastic_s = 10.0, .fluid_s = 10.0};

/// Steps of 2 s, halved at most to 2 s/128; nothing may move further than 0.2 spacings of 2 um.
Parameters adaptive() {
  Parameters p;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 2.0;
  return p;
}

/// One particle of the matrix and one of the cortex.
State at(double t, double v_matrix = 0.0, double v_cortex = 0.0) {
  State s;
  s.t = t;
  s.ecm.v = {Vec2(0.0, v_matrix)};
  s.cells.emplace_back().cortex.v = {Vec2(v_cortex, 0.0)};
  return s;
}

} // namespace

TEST(StepToTry, IsTheWholeStepWhereNothingStandsAgainstIt) {
  EXPECT_EQ(step_to_try(at(0.0), adaptive(), long_enough), 2.0);
  EXPECT_EQ(step_to_try(at(14.0), adaptive(), long_enough), 2.0);
}

TEST(StepToTry, LeadsBackToTheMultiplesOfTheLongestStep) {
  EXPECT_EQ(step_to_try(at(13.0), adaptive(), long_enough), 1.0);
  EXPECT_EQ(step_to_try(at(13.5), adaptive(), long_enough), 0.5);
  EXPECT_EQ(step_to_try(at(12.5), adaptive(), long_enough), 0.5) << "then 1 s from 13 s on";
  EXPECT_EQ(step_to_try(at(12.0 + 2.0 / 128.0), adaptive(), long_enough), 2.0 / 128.0);
}

TEST(StepToTry, IsHalvedUntilNothingMovesAFifthFurtherThanItMay) {
  const double most = 1.2 * 0.2 * 2.0; // [um]
  EXPECT_EQ(step_to_try(at(0.0, 0.99 * most / 2.0), adaptive(), long_enough), 2.0);
  EXPECT_EQ(step_to_try(at(0.0, 1.01 * most / 2.0), adaptive(), long_enough), 1.0);
  EXPECT_EQ(step_to_try(at(0.0, 0.0, -1.01 * most), adaptive(), long_enough), 0.5) << "the cortex counts, too";
  EXPECT_EQ(step_to_try(at(0.0, 1e9), adaptive(), long_enough), 2.0 / 128.0) << "and no further";
}

TEST(StepToTry, IsStable) {
  EXPECT_EQ(step_to_try(at(0.0), adaptive(), {.elastic_s = 0.3, .fluid_s = 10.0}), 1.0); // within four times the limit
}
