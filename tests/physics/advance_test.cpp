#include "base/failure.hpp"
#include "simulation/advance.hpp"
#include "simulation/step_limits.hpp"
#include "sph/interpolate.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace matrigrate;

namespace {

Parameters small() {
  Parameters p;
  p.ecm.radius = 60.0;
  return p;
}

State start(const Parameters& p) {
  State s;
  s.ecm = disc(p);
  return s;
}

/// A pull at a point of the solid, and degradation beside it.
State pulled(const Parameters& p, int steps, bool fresh_workspace_half_way = false) {
  State s = start(p);
  auto w = std::make_unique<Workspace>(s, p);
  const Loads load = [](const State& at, std::span<Vec2> force) {
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(-0.3, 0.1), force);
  };
  for (int k = 0; k < steps; ++k) {
    if (fresh_workspace_half_way && k == steps / 2) w = std::make_unique<Workspace>(s, p);
    advance(s, p, *w, load);
    for (std::size_t i = 0; i < s.ecm.size(); ++i) // a tunnel grows to the left
      if (!s.ecm.clamped[i] && std::abs(s.ecm.X[i].y()) < 3.0 && s.ecm.X[i].x() < 0.0 && s.ecm.X[i].x() > -30.0)
        s.ecm.f[i] = std::max(0.0, s.ecm.f[i] - 0.05);
  }
  return s;
}

bool same_bits(const State& a, const State& b) {
  const auto bytes = [](const auto& u, const auto& v) {
    return u.size() == v.size() && std::memcmp(u.data(), v.data(), u.size() * sizeof(u[0])) == 0;
  };
  return bytes(a.ecm.x, b.ecm.x) && bytes(a.ecm.v, b.ecm.v) && bytes(a.ecm.rho, b.ecm.rho) && bytes(a.ecm.S, b.ecm.S)
         && bytes(a.ecm.f, b.ecm.f);
}

} // namespace

TEST(Advance, AGelAtRestStaysAtRest) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  for (int k = 0; k < 5; ++k) advance(s, p, w);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) EXPECT_LT(s.ecm.displacement(i).norm(), 1e-12);
  EXPECT_EQ(s.step, 5U);
  EXPECT_DOUBLE_EQ(s.t, 2.0);
}

TEST(Advance, GivesTheSameBitsForAnyNumberOfThreads) {
  const Parameters p = small();
  const auto with_threads = [&](std::size_t n) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, n);
    return pulled(p, 40);
  };
  const State one = with_threads(1);
  EXPECT_TRUE(same_bits(one, with_threads(2)));
  EXPECT_TRUE(same_bits(one, with_threads(4)));
}

TEST(Advance, GivesTheSameBitsWithAFreshWorkspace) { // what a restart does
  EXPECT_TRUE(same_bits(pulled(small(), 40), pulled(small(), 40, true)));
}

TEST(Advance, GivesTheSameBitsForAnySkinOfTheNeighbourList) {
  Parameters wide = small();
  wide.ecm.verlet_skin = 3.0;
  EXPECT_TRUE(same_bits(pulled(small(), 40), pulled(wide, 40)));
}

TEST(Advance, ForcesBalanceToTheTolerance) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  advance(s, p, w, [](const State& at, std::span<Vec2> force) {
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(-0.3, 0.1), force);
  });
  EXPECT_LE(w.health.solve.residual, p.solver.tolerance);
  EXPECT_GT(w.health.solve.iterations, 1);
}

TEST(Advance, StopsWithItsReasonWhenTheSolverGivesUp) {
  Parameters p = small();
  p.solver.max_iterations = 2;
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State&, std::span<Vec2> force) { force[force.size() / 2] += Vec2(0.1, 0.0); };
  try {
    advance(s, p, w, load);
    FAIL() << "no failure was reported";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("was not solved"), std::string::npos);
  }
  EXPECT_EQ(s.step, 0U);
}

TEST(Advance, StopsBeforeAForceThatIsNotANumberSpreads) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State&, std::span<Vec2> force) {
    force[force.size() / 3] += Vec2(std::numeric_limits<double>::quiet_NaN(), 0.0);
  };
  EXPECT_THROW(advance(s, p, w, load), NumericalFailure);
  for (const Vec2& x : s.ecm.x) EXPECT_TRUE(x.allFinite());
}

TEST(Advance, StopsWhenAParticleWouldLeapOverItsNeighbours) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State&, std::span<Vec2> force) { force[force.size() / 3] += Vec2(1000.0, 0.0); };
  EXPECT_THROW(advance(s, p, w, load), NumericalFailure);
}

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
