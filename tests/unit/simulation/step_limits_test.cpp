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
