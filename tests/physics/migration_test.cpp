#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "cell/geometry.hpp"
#include "gel.hpp"
#include "protrusion/growth.hpp"
#include "protrusion/maturation.hpp"
#include "simulation/advance.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "state/dof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

using namespace matrigrate;

namespace {

/// A cell whose protrusions live fast, so that a minute shows every phase.
Parameters hasty() {
  Parameters p;
  p.ecm.radius = 60.0;
  p.protrusion.initiation_rate = 2e-3;
  p.protrusion.growth_time = 40.0;
  p.protrusion.finishing_time = 10.0;
  p.adhesion.maturation_time = 20.0;
  p.adhesion.r_off_min = 0.05;
  p.solver.tolerance = 1e-8;
  return p;
}

State migrated(const Parameters& p, int steps, bool fresh_workspaces = false) {
  State s = initial_state(p);
  auto w = std::make_unique<Workspace>(s, p);
  for (int k = 0; k < steps; ++k) {
    if (fresh_workspaces && k % 50 == 49) w = std::make_unique<Workspace>(s, p);
    advance(s, p, p.run.time_step, *w);
  }
  return s;
}

Vec2 sum(const std::vector<Vec2>& a) { return std::accumulate(a.begin(), a.end(), Vec2(Vec2::Zero())); }

} // namespace

TEST(Migration, ACellWithoutProtrusionsStaysInItsHole) {
  Parameters p = hasty();
  p.protrusion.initiation_rate = 0.0;
  const State s = migrated(p, 100);
  EXPECT_LT(centroid(s.cells[0].cortex).norm(), 1e-3);
  EXPECT_NEAR(area(s.cells[0].cortex), initial_area(p.cell), 0.01 * initial_area(p.cell));
  EXPECT_FALSE(s.cells[0].polarization);
}

TEST(Migration, PassesThroughEveryPhase) {
  const State s = migrated(hasty(), 300);
  EXPECT_GE(s.cells[0].initiated, 1U);
  ASSERT_FALSE(s.cells[0].ended.empty());
  const ProtrusionRecord& r = s.cells[0].ended.front();
  EXPECT_LT(r.t_initiation, r.t_adhesion);
  EXPECT_NEAR(r.t_adhesion - r.t_initiation, 40.0, 0.41);
  EXPECT_NEAR(r.t_mature - r.t_adhesion, 20.0, 0.41);
  EXPECT_GT(r.t_disassembly, r.t_mature);
  EXPECT_NEAR(r.t_end - r.t_disassembly, 10.0, 0.41);
  EXPECT_EQ(r.cause, EndCause::disassembly);
  EXPECT_GT(r.length, 3.0);
  EXPECT_TRUE(s.cells[0].polarization);
  EXPECT_FALSE(crosses_itself(s.cells[0].cortex));
}

TEST(Migration, GivesTheSameBitsForAnyNumberOfThreads) {
  const auto with_threads = [](int n) {
    const ThreadLimit limit(n);
    return migrated(hasty(), 200);
  };
  const State one = with_threads(1);
  EXPECT_TRUE(same_bits(one, with_threads(2)));
  EXPECT_TRUE(same_bits(one, with_threads(4)));
}

TEST(Migration, GivesTheSameBitsWithFreshWorkspaces) { // what a restart does
  EXPECT_TRUE(same_bits(migrated(hasty(), 200), migrated(hasty(), 200, true)));
}

TEST(Migration, AdaptiveStepsGiveTheSameBitsWithFreshWorkspaces) {
  Parameters p = hasty();
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 2.0;
  const auto marched = [&p](double pause) {
    State s = initial_state(p);
    for (double t = pause; t < 240.0 + 1e-9; t += pause) {
      Workspace w(s, p);
      march(s, p, w, t);
    }
    return s;
  };
  const State s = marched(240.0);
  EXPECT_GT(s.cells[0].initiated, 0U);
  EXPECT_GT(s.step, 120U); // some were halved
  EXPECT_TRUE(same_bits(s, marched(60.0)));
}

TEST(Migration, SeedsBeginTheirFirstProtrusionElsewhere) {
  const auto first = [](std::uint64_t seed) { // its time, and the particle
    Parameters p = hasty();
    p.run.seed = seed;
    State s = initial_state(p);
    Workspace w(s, p);
    while (s.cells[0].protrusions.empty()) advance(s, p, p.run.time_step, w);
    return std::pair(s.step, s.cells[0].protrusions.front().centre);
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(2));
  EXPECT_NE(first(1), first(3));
}

TEST(Migration, InternalForcesCancel) { // third law over matrix, cell and all that joins them
  const Parameters p = hasty();
  State s = initial_state(p);
  Workspace w(s, p);
  double most = 0.0;
  for (int k = 0; k < 300; ++k) {
    advance(s, p, p.run.time_step, w);
    assemble(s, p, p.run.time_step, w);
    complete_forces(s, p, w, {});
    std::vector<Vec2> external(w.force.size(), Vec2::Zero());
    const std::uint32_t first = first_node(s, 0);
    add_growth(s.cells[0], p.protrusion, 1.0, w.cells[0].normals, first, external, w.drag, s.t,
               w.laws.front().growth_force);
    add_maturation(s.cells[0], p, w.laws.front(), {}, p.run.time_step, first, external, w.drag);
    most = std::max(most, (sum(w.force) - sum(external)).norm());
  }
  EXPECT_LT(most, 1e-12);
}

TEST(Migration, ACellInFluidIsResistedByItsOwnDragAndByAShareOfTheFluid) {
  const auto speed = [](double share) {
    Parameters p = hasty();
    p.protrusion.initiation_rate = 0.0;
    p.contact.body_fluid_share = share;
    State s = initial_state(p);
    for (std::size_t i = 0; i < s.ecm.size(); ++i)
      if (!s.ecm.clamped[i]) s.ecm.f[i] = 0.0;
    Workspace w(s, p);
    advance(s, p, p.run.time_step, w, [](const State& at, std::span<Vec2> force) {
      for (Vec2& f : of_cell(at, 0, force)) f += Vec2(1e-3, 0.0);
    });
    Vec2 mean = Vec2::Zero();
    for (const Vec2& v : s.cells[0].cortex.v) mean += v / static_cast<double>(s.cells[0].cortex.size());
    return mean.x();
  };
  const double alone = 1e-3 / 0.04; // F / gamma_liquid
  EXPECT_NEAR(speed(0.0), alone, 1e-6);
  EXPECT_LT(speed(0.1), 0.9 * alone);
  EXPECT_LT(speed(0.2), 0.95 * speed(0.1));
}

TEST(Migration, StopsAtTheRim) {
  Parameters p = hasty();
  p.ecm.radius = 30.0;
  State s = initial_state(p);
  Workspace w(s, p);
  try {
    march(s, p, w, 600.0);
    FAIL() << "it went on";
  } catch (const NumericalFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("rim"), std::string::npos) << failure.what();
  }
}

TEST(Migration, ProtrusionsBeginWhereThePropensityLetsThem) {
  const Parameters p = hasty();
  const auto with_propensity = [&p](auto factor_at) {
    State s = initial_state(p);
    Workspace w(s, p);
    for (int k = 0; k < 300; ++k) {
      w.propensity.assign(1, {});
      for (const Vec2& x : s.cells[0].cortex.x) w.propensity[0].push_back(factor_at(x));
      advance(s, p, p.run.time_step, w);
    }
    return s;
  };
  EXPECT_TRUE(same_bits(migrated(p, 300), with_propensity([](const Vec2&) { return 1.0; })));
  EXPECT_EQ(with_propensity([](const Vec2&) { return 0.0; }).cells[0].initiated, 0U);
  const Cell above = with_propensity([](const Vec2& x) { return x.y() < 0.0 ? 0.0 : 1.0; }).cells[0];
  EXPECT_GT(above.initiated, 0U);
  const CortexState start = round_cortex(p.cell);
  for (const ProtrusionRecord& r : above.ended) EXPECT_GT(start.x[r.centre].y(), -1.0);
  for (const Protrusion& protrusion : above.protrusions) EXPECT_GT(start.x[protrusion.centre].y(), -1.0);
}
