#include "base/failure.hpp"
#include "base/parallel.hpp"
#include "cell/geometry.hpp"
#include "ecm/degradation.hpp"
#include "gel.hpp"
#include "observe/health.hpp"
#include "parameters/read.hpp"
#include "simulation/advance.hpp"
#include "simulation/start.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace matrigrate;

namespace {

/// Cells whose protrusions live fast.
Parameters hasty_cells() {
  Parameters p;
  p.ecm.radius = 70.0;
  p.cell.start_x = -24.0;
  p.protrusion.initiation_rate = 5e-4;
  p.protrusion.growth_time = 40.0;
  p.adhesion.maturation_time = 20.0;
  p.protrusion.finishing_time = 10.0;
  p.adhesion.r_off_min = 0.1;
  return p;
}

/// Two round cells with a hole each, the second one to the right.
State two_cells(const Parameters& p) {
  State s = initial_state(p);
  Parameters beside = p;
  beside.cell.start_x = 24.0;
  Cell second;
  second.id = 1;
  second.cortex = round_cortex(beside.cell);
  s.cells.push_back(second);
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if ((s.ecm.X[i] - Vec2(24.0, 0.0)).norm() < p.cell.radius + p.degradation.body_distance) fluidize(s.ecm, i);
  return s;
}

} // namespace

TEST(TwoCells, LiveInOneMatrix) {
  const Parameters p = hasty_cells();
  State s = two_cells(p);
  Workspace w(s, p);
  double imbalance = 0.0;
  for (int k = 0; k < 300; ++k) {
    advance(s, p, p.run.time_step, w);
    imbalance = std::max(imbalance, force_imbalance(w));
  }
  EXPECT_LT(imbalance, 1e-9) << "third law over the matrix and both cells";
  ASSERT_EQ(s.cells.size(), 2U);
  for (const Cell& cell : s.cells) {
    EXPECT_GE(cell.initiated, 1U) << cell.id;
    EXPECT_FALSE(crosses_itself(cell.cortex)) << cell.id;
    EXPECT_NEAR(area(cell.cortex), initial_area(p.cell), 0.5 * initial_area(p.cell)) << cell.id;
  }
  EXPECT_LT(centroid(s.cells[0].cortex).x(), -15.0);
  EXPECT_GT(centroid(s.cells[1].cortex).x(), 15.0);
  const auto begins = [](const Cell& cell) {
    return cell.ended.empty() ? cell.protrusions.front().record.t_initiation : cell.ended.front().t_initiation;
  };
  EXPECT_NE(begins(s.cells[0]), begins(s.cells[1]));
}

TEST(TwoCells, GoOnFromACheckpointWithTheSameBits) {
  const Parameters p = hasty_cells();
  State s = two_cells(p);
  Workspace w(s, p);
  for (int k = 0; k < 40; ++k) advance(s, p, p.run.time_step, w);
  State read = store::parse_checkpoint(store::checkpoint_image({s, {}, {}, {}, {}}), "c.h5").state;
  EXPECT_TRUE(same_bits(read, s));
  Workspace fresh(read, p);
  for (int k = 0; k < 40; ++k) {
    advance(s, p, p.run.time_step, w);
    advance(read, p, p.run.time_step, fresh);
  }
  EXPECT_TRUE(same_bits(read, s));
}

TEST(TwoCells, GiveTheSameBitsForAnyNumberOfThreads) { // their protrusions are advanced side by side, laws are formulas
  const Parameters p = apply_overrides(
      hasty_cells(), {"laws.initiation_bias=1 + 0.01*abs(x)", "laws.maturation_force=0.1*steps*(m_mat*F_am)"});
  const auto at_end = [&](int threads) {
    const ThreadLimit limit(threads);
    State s = two_cells(p);
    Workspace w(s, p);
    for (int k = 0; k < 200; ++k) advance(s, p, p.run.time_step, w);
    return s;
  };
  const State one = at_end(1);
  EXPECT_GT(one.cells[0].initiated + one.cells[1].initiated, 1U);
  for (const int threads : {2, 3, 5}) EXPECT_TRUE(same_bits(one, at_end(threads))) << threads;
}

TEST(TwoCells, MoveByTheVelocitiesTheyTake) {
  const Parameters p = apply_overrides(hasty_cells(), {"nucleus.radius=5 um"});
  State s = two_cells(p);
  ASSERT_GT(s.cells[0].nucleus.size(), 0U);
  Workspace w(s, p);
  for (int k = 0; k < 3; ++k) {
    const State before = s;
    advance(s, p, p.run.time_step, w);
    EXPECT_EQ(node_velocities(s), w.v);
    for (std::size_t i = 0; i < w.v.size(); ++i)
      EXPECT_LT((node_position(s, i) - node_position(before, i) - p.run.time_step * w.v[i]).norm(), 1e-12) << i;
  }
  EXPECT_GT(w.v[first_nucleus_node(s, 0)].norm() + w.v[first_node(s, 1)].norm(), 0.0);
}

TEST(TwoCells, IfBothFailTheFirstIsNamed) {
  Parameters p = hasty_cells();
  p.laws.initiation_rate = "-abs(x)";
  for (const int threads : {1, 2, 5})
    for (int again = 0; again < 5; ++again) {
      const ThreadLimit limit(threads);
      State s = two_cells(p);
      Workspace w(s, p);
      std::string why;
      try {
        advance(s, p, p.run.time_step, w);
      } catch (const NumericalFailure& failure) {
        why = failure.what();
      }
      EXPECT_NE(why.find("x = -"), std::string::npos) << threads << ": " << why; // the first cell is on the left
    }
}

// Without protrusions nothing tells the cells apart: their order is that of sums.
TEST(TwoCells, DoNotDependOnTheirOrder) {
  Parameters p = hasty_cells();
  p.protrusion.initiation_rate = 0.0;
  State s = two_cells(p);
  State swapped = s;
  std::swap(swapped.cells[0], swapped.cells[1]);
  Workspace w(s, p), w_swapped(swapped, p);
  for (int k = 0; k < 20; ++k) {
    advance(s, p, p.run.time_step, w);
    advance(swapped, p, p.run.time_step, w_swapped);
  }
  for (std::size_t i = 0; i < s.cells[0].cortex.size(); ++i) {
    EXPECT_LT((s.cells[0].cortex.x[i] - swapped.cells[1].cortex.x[i]).norm(), 1e-6);
    EXPECT_LT((s.cells[1].cortex.x[i] - swapped.cells[0].cortex.x[i]).norm(), 1e-6);
  }
}
