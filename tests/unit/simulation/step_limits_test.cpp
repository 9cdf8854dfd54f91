#include "simulation/march.hpp"
#include "simulation/step_limits.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

TEST(StepLimits, AreSetByTheModuliOverTheViscosity) {
  Parameters p;
  const StepLimits at_200 = step_limits(p);
  EXPECT_NEAR(at_200.elastic_s, 2.0 / (0.2 / 0.3 + 4.0 / 3.0 * 0.2 / 2.9), 0.1); // about 2 mu/(K + 4G/3)
  p.ecm.youngs_modulus = 0.4;
  EXPECT_NEAR(step_limits(p).elastic_s, 0.5 * at_200.elastic_s, 1e-12);
  EXPECT_NEAR(step_limits(p).fluid_s, 0.5 * at_200.fluid_s, 1e-12);
  p.ecm.viscosity = 2.0;
  EXPECT_NEAR(step_limits(p).elastic_s, at_200.elastic_s, 1e-12);
  p.ecm.particle_spacing = 1.0;
  p.ecm.smoothing_length = 1.3;
  EXPECT_NEAR(step_limits(p).elastic_s, at_200.elastic_s, 1e-9); // not by the spacing itself
}

TEST(LongestStep, IsHalvedUntilItIsStable) {
  Parameters p;
  const StepLimits limits{.elastic_s = 0.3, .fluid_s = 0.5};
  p.run.time_step = 0.4;
  EXPECT_EQ(longest_step(p, limits), 0.4) << "the reference takes its step as it is";
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 5.0;
  EXPECT_EQ(longest_step(p, limits), 0.625); // within 1.2 s, four times the shorter limit
  p.run.time_step = 1.0;
  EXPECT_EQ(longest_step(p, limits), 1.0);
}

TEST(AdaptiveStep, LeavesOpenWhatIsSmallBesideItsOwnError) {
  Parameters p;
  EXPECT_EQ(solver_tolerance(p), p.solver.tolerance);
  EXPECT_EQ(drag_lag(p, 2.4), p.ecm.drag_lag);
  p.run.integrator = Integrator::adaptive;
  EXPECT_DOUBLE_EQ(solver_tolerance(p), 100.0 * p.solver.tolerance);
  EXPECT_DOUBLE_EQ(drag_lag(p, 2.4), 6.0 * p.ecm.drag_lag);
  EXPECT_EQ(drag_lag(p, 0.1), p.ecm.drag_lag);
  p.solver.method = SolverMethod::conjugate_gradient; // whose error is thirty times that of multigrid
  EXPECT_EQ(solver_tolerance(p), p.solver.tolerance);
}

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
