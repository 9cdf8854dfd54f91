#include "simulation/simulation.hpp"

#include "base/failure.hpp"
#include "same_bits.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

Parameters small() {
  Parameters p;
  p.ecm.radius = 40.0;
  p.protrusion.initiation_rate = 1e-2;
  p.run.time_step = 0.4;
  return p;
}

TEST(Simulation, MarchesAsStateAndWorkspaceDo) {
  const Parameters p = small();
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 8.0);
  Simulation simulation(p);
  simulation.march_for(4.0);
  simulation.march(8.0);
  EXPECT_TRUE(same_bits(simulation.s, s));
}

TEST(Simulation, ChangesParametersAtTheNextMultipleOfTheStep) {
  Simulation simulation(small());
  int steps = 0;
  simulation.march(2.0, {}, [&](const State& /*now*/) { return ++steps < 3; });
  EXPECT_EQ(steps, 3);
  const std::size_t builds = simulation.w.health.list_builds;
  Parameters after = simulation.p;
  after.actomyosin.force = 2.0;
  after.run.time_step = 0.2;
  simulation.change(after);
  EXPECT_DOUBLE_EQ(simulation.s.t, 1.2);
  EXPECT_EQ(simulation.p.actomyosin.force, 2.0);
  EXPECT_GE(simulation.w.health.list_builds, builds);
  simulation.march(1.6);
  EXPECT_EQ(simulation.s.step, 5U);
}

TEST(Simulation, RefusesParametersThatTheStateWasMadeWith) {
  Simulation simulation(small());
  Parameters after = simulation.p;
  after.ecm.radius = 50.0;
  EXPECT_THROW(simulation.change(after), ConfigurationError);
  EXPECT_EQ(simulation.p.ecm.radius, 40.0);
  EXPECT_EQ(simulation.s.step, 0U);
}

} // namespace
} // namespace matrigrate
