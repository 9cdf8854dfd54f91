#include "simulation/simulation.hpp"

#include "base/failure.hpp"
#include "gel.hpp"
#include "parameters/changes.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

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

/// Two changes: one of forces, one that turns fibres on and stiffens the matrix.
Parameters with_changes() {
  Parameters p = small();
  p.changes = {{2.0, "actomyosin.force", "\"2 nN\""},
               {2.0, "ecm.viscosity", "\"3000 Pa s\""},
               {4.0, "fibres.arrangement", "\"isotropic\""},
               {4.0, "ecm.youngs_modulus", "\"300 Pa\""}};
  return p;
}

TEST(Simulation, ChangesParametersInTimeAsIfByHand) {
  Simulation simulation(with_changes()), by_hand(small()), without(small());
  simulation.march(8.0);
  for (const double at : {2.0, 4.0}) {
    by_hand.march(at);
    Parameters after = in_force(with_changes(), at);
    after.changes.clear();
    by_hand.change(after);
  }
  by_hand.march(8.0);
  without.march(8.0);
  EXPECT_TRUE(same_bits(simulation.s, by_hand.s));
  EXPECT_FALSE(same_bits(simulation.s, without.s));
  EXPECT_TRUE(simulation.p.changes.empty());
}

TEST(Simulation, ChangesParametersInTimeAlsoFromAnyStateOnTheWay) {
  Simulation whole(with_changes());
  std::vector<State> states{whole.s};
  whole.march(6.0, {}, [&](const State& s) {
    states.push_back(s);
    return true;
  });
  ASSERT_EQ(states.size(), 16U);
  for (State& state : states) {
    Simulation later(with_changes(), state);
    later.march(6.0);
    EXPECT_TRUE(same_bits(later.s, whole.s)) << "from " << state.t << " s";
  }
}

TEST(Simulation, AnObserverEndsAMarchAlsoAtATimeOfChange) {
  Simulation simulation(with_changes());
  simulation.march(8.0, {}, [](const State& s) { return s.t < 1.9; });
  EXPECT_DOUBLE_EQ(simulation.s.t, 2.0);
  EXPECT_EQ(simulation.p.actomyosin.force, small().actomyosin.force);
  simulation.march(2.4);
  EXPECT_EQ(simulation.p.actomyosin.force, 2.0);
}

TEST(Simulation, RefusesParametersThatTheStateWasMadeWith) {
  Simulation simulation(small());
  Parameters after = simulation.p;
  after.ecm.radius = 50.0;
  EXPECT_THROW(simulation.change(after), ConfigurationError);
  EXPECT_EQ(simulation.p.ecm.radius, 40.0);
  EXPECT_EQ(simulation.s.step, 0U);
}

TEST(Simulation, DoesNotGoOnFromAStepThatBrokeOff) {
  Parameters p = small();
  p.laws.polarization_rate = "r_pol";
  p.laws.disassembly_rate = "F > 1e-6 ? -1 : 0.001"; // not allowed once an adhesion pulls
  p.adhesion.maturation_time = p.protrusion.growth_time = p.protrusion.finishing_time = 4.0;
  p.protrusion.force = 0.6;
  Simulation simulation(p);
  EXPECT_THROW(simulation.march(600.0), NumericalFailure);
  ASSERT_TRUE(simulation.failure);
  EXPECT_EQ(simulation.failure->cause(), FailureCause::law);
  const State broken = simulation.s;
  for (const double t_end : {600.0, broken.t, 0.0}) try {
      simulation.march(t_end);
      ADD_FAILURE() << "went on to " << simulation.s.t << " s";
    } catch (const NumericalFailure& error) {
      EXPECT_EQ(error.cause(), FailureCause::law);
      EXPECT_EQ(std::string(error.what()).find(fmt::format("failed at {:.6g} s and cannot go on", broken.t)), 0U);
    }
  EXPECT_THROW(simulation.change(p), NumericalFailure);
  EXPECT_TRUE(same_bits(simulation.s, broken));
}

/// What a user's own function throws ends a march between two steps.
TEST(Simulation, GoesOnAfterAnExceptionOfAnObserver) {
  Simulation simulation(small());
  Simulation whole(small());
  const auto end_it = [](const State& s) {
    if (s.step == 3) throw std::runtime_error("enough");
    return true;
  };
  EXPECT_THROW(simulation.march(8.0, {}, end_it), std::runtime_error);
  EXPECT_FALSE(simulation.failure);
  simulation.march(8.0);
  whole.march(8.0);
  EXPECT_TRUE(same_bits(simulation.s, whole.s));
}

} // namespace
} // namespace matrigrate
