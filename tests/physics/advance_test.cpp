#include "base/parallel.hpp"
#include "simulation/advance.hpp"

#include "base/failure.hpp"
#include "cell/geometry.hpp"
#include "ecm/loop/viscosity.hpp"
#include "gel.hpp"
#include "simulation/start.hpp"
#include "simulation/step_limits.hpp"
#include "sph/interpolate.hpp"
#include "state/dof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

using namespace matrigrate;

namespace {

/// A pull at a point of the solid, and degradation beside it.
State pulled(const Parameters& p, int steps, bool fresh_workspace_half_way = false) {
  State s = start(p);
  auto w = std::make_unique<Workspace>(s, p);
  const Loads load = [](const State& at, std::span<Vec2> force) {
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(-0.3, 0.1), force);
  };
  for (int k = 0; k < steps; ++k) {
    if (fresh_workspace_half_way && k == steps / 2) w = std::make_unique<Workspace>(s, p);
    advance(s, p, p.run.time_step, *w, load);
    for (std::size_t i = 0; i < s.ecm.size(); ++i) // a tunnel grows to the left
      if (!s.ecm.clamped[i] && std::abs(s.ecm.X[i].y()) < 3.0 && s.ecm.X[i].x() < 0.0 && s.ecm.X[i].x() > -30.0)
        s.ecm.f[i] = std::max(0.0, s.ecm.f[i] - 0.05);
  }
  return s;
}

} // namespace

// A load may be a function of Python, which holds its lock on the thread that calls.
TEST(Advance, CallsLoadsOnTheThreadOfTheCaller) {
  const ThreadLimit threads(4);
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  const std::thread::id caller = std::this_thread::get_id();
  int here = 0;
  const Loads load = [&](const State&, std::span<Vec2>) { here += std::this_thread::get_id() == caller ? 1 : 0; };
  for (int k = 0; k < 50; ++k) advance(s, p, p.run.time_step, w, load);
  EXPECT_EQ(here, 50);
}

TEST(Advance, AGelAtRestStaysAtRest) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  for (int k = 0; k < 5; ++k) advance(s, p, p.run.time_step, w);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) EXPECT_LT(s.ecm.displacement(i).norm(), 1e-12);
  EXPECT_EQ(s.step, 5U);
  EXPECT_DOUBLE_EQ(s.t, 2.0);
}

TEST(Advance, GivesTheSameBitsForAnyNumberOfThreads) {
  const Parameters p = small();
  const auto with_threads = [&](int n) {
    const ThreadLimit limit(n);
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

TEST(Advance, ForcesAndDragBalanceToTheTolerance) { // Eq. 2, pair by pair from its definition
  const Parameters p = small();
  State s = pulled(p, 3);
  const std::vector<Vec2> x = s.ecm.x;
  Workspace w(s, p);
  advance(s, p, p.run.time_step, w, [](const State& at, std::span<Vec2> force) {
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(-0.3, 0.1), force);
  });
  const Kernel kernel(p.ecm.smoothing_length);
  const Adjacency pairs = neighbours_within(x, kernel.support(), 0.0);
  double unbalanced = 0.0;
  double force = 0.0;
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    if (s.ecm.clamped[i]) continue;
    Vec2 sum = w.force[i];
    for (const std::uint32_t j : pairs.of(i)) {
      const double r2 = (x[i] - x[j]).squaredNorm();
      sum -= pair_drag(r2, kernel.W_slope(std::sqrt(r2)), s.ecm.V0, p.ecm.viscosity, p.ecm.thickness, kernel.h())
             * (s.ecm.v[i] - s.ecm.v[j]);
    }
    unbalanced += sum.squaredNorm();
    force += w.force[i].squaredNorm();
  }
  EXPECT_GT(std::sqrt(force), 0.1);
  EXPECT_LE(std::sqrt(unbalanced / force), p.solver.tolerance + 1e-6); // coefficients are in single precision
}

TEST(Advance, StopsWithItsReasonWhenTheSolverGivesUp) {
  Parameters p = small();
  p.solver.max_iterations = 2;
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State&, std::span<Vec2> force) { force[force.size() / 2] += Vec2(0.1, 0.0); };
  try {
    advance(s, p, p.run.time_step, w, load);
    FAIL() << "no failure was reported";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("was not solved"), std::string::npos);
  }
  EXPECT_EQ(s.step, 0U);
}

TEST(Advance, StopsBeforeAForceThatIsNoFiniteNumberSpreads) {
  Parameters p = small();
  for (const SolverMethod method : {SolverMethod::multigrid, SolverMethod::conjugate_gradient})
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
      p.solver.method = method;
      State s = start(p);
      Workspace w(s, p);
      const Loads load = [value](const State&, std::span<Vec2> force) { force[force.size() / 3] += Vec2(value, 0.0); };
      EXPECT_THROW(advance(s, p, p.run.time_step, w, load), NumericalFailure) << value;
      EXPECT_EQ(s.step, 0U);
      for (const Vec2& x : s.ecm.x) EXPECT_TRUE(x.allFinite());
    }
}

TEST(Advance, StopsWhenAParticleWouldLeapOverItsNeighbours) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State&, std::span<Vec2> force) { force[force.size() / 3] += Vec2(1000.0, 0.0); };
  EXPECT_THROW(advance(s, p, p.run.time_step, w, load), NumericalFailure);
}

TEST(RelaxationTheta, BearsStepsBeyondTheLimitOfTheExplicitStep) {
  Parameters p = small();
  p.run.time_step = 1.7 * step_limits(p).smallest();
  const StepLimits limits = step_limits(p);
  EXPECT_EQ(relaxation_theta(p, p.run.time_step, limits), 0.0);
  EXPECT_EQ(largest_step(p, limits), limits.smallest());
  p.run.integrator = Integrator::adaptive;
  EXPECT_NEAR(relaxation_theta(p, p.run.time_step, limits),
              0.5 * p.run.time_step * (1.0 / limits.elastic_s + 1.0 / limits.fluid_s) - 0.4, 1e-12);
  EXPECT_GT(largest_step(p, limits), p.run.time_step);

  const auto energy_left = [](const Parameters& q) { // of waves of all lengths, after 40 steps
    State s = start(q);
    for (std::size_t i = 0; i < s.ecm.size(); ++i) {
      const double phase = static_cast<double>(i);
      if (!s.ecm.clamped[i]) s.ecm.v[i] = 1e-6 * Vec2(std::sin(12.9898 * phase), std::sin(78.233 * phase));
      s.ecm.x[i] += s.ecm.v[i];
    }
    Workspace w(s, q);
    SolidFields at_rest = undeformed(s.ecm.size());
    advance_stress(s.ecm, q.ecm, w.reference, at_rest, 1.0); // the stress of the displacement
    double before = 0.0, after = 0.0;
    for (const Mat2& S : s.ecm.S) before += S.squaredNorm();
    for (Vec2& v : s.ecm.v) v.setZero();
    for (int k = 0; k < 40 && after < 1e6 * before; ++k) {
      advance(s, q, q.run.time_step, w);
      after = 0.0;
      for (const Mat2& S : s.ecm.S) after += S.squaredNorm();
    }
    return after / before;
  };
  EXPECT_LT(energy_left(p), 1e-3);
  p.run.integrator = Integrator::reference;
  EXPECT_GT(energy_left(p), 1e3);
}

TEST(AdaptiveStep, IsNotTakenAtAllWhereItWouldBeTooLong) {
  const Parameters p = small();
  State s = start(p);
  Workspace w(s, p);
  const Loads load = [](const State& at, std::span<Vec2> force) {
    spread(solid_weights(at.ecm, Kernel(2.6), Vec2(25.0, 0.0)), Vec2(1.0, 0.0), force);
  };
  advance(s, p, p.run.time_step, w, load);
  const State before = s;
  ASSERT_NE(s.ecm.x, s.solver_memory.x_drag);
  const auto refused = advance(s, p, p.run.time_step, w, load, {.max_move = 1e-6});
  ASSERT_TRUE(refused.has_value());
  EXPECT_NE(refused->reason.find("beyond the limit of 1e-06 um"), std::string::npos) << refused->reason;
  EXPECT_TRUE(same_bits(s, before));
  advance(s, p, p.run.time_step, w, load);
  EXPECT_FALSE(same_bits(s, before));
}

TEST(AdaptiveStep, DoesNotLetTheCellCrossItself) {
  Parameters p;
  p.ecm.radius = 40.0;
  p.contact.fluid_share = p.contact.body_fluid_share = 0.0; // nothing but the cell is in the way
  p.cell.bending_stiffness = 0.05;                          // and that bends easily
  State s = initial_state(p);
  Workspace w(s, p);
  const std::uint32_t outermost = first_node(s, 0);
  const Loads load = [&](const State&, std::span<Vec2> force) { force[outermost] += Vec2(-22.0, 0.0); };
  const StepBounds anything{.max_move = 1e9, .may_cross = false};
  const State before = s;
  const auto refused = advance(s, p, p.run.time_step, w, load, anything);
  ASSERT_TRUE(refused.has_value()) << "pushed out at the other side";
  EXPECT_NE(refused->reason.find("would cross itself"), std::string::npos) << refused->reason;
  EXPECT_TRUE(same_bits(s, before));
  EXPECT_FALSE(advance(s, p, p.run.time_step, w, load, {.max_move = 1e9}).has_value());
  EXPECT_TRUE(crosses_itself(s.cells[0].cortex));
}
