#include "cell/geometry.hpp"
#include "gel.hpp"
#include "observe/health.hpp"
#include "observe/tracks.hpp"
#include "simulation/advance.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace matrigrate;

namespace {

/// Cells in a row, `distance` apart from centre to centre.
Parameters row_of_cells(std::size_t n, double distance) {
  Parameters p;
  p.ecm.radius = 0.5 * distance * static_cast<double>(n) + 50.0;
  for (std::size_t k = 0; k < n; ++k)
    p.cells.push_back({distance * (static_cast<double>(k) - 0.5 * static_cast<double>(n - 1)), 0.0});
  return p;
}

/// Pushes two cells of two towards each other.
Loads press(double force) {
  return [force](const State& s, std::span<Vec2> f) {
    for (const std::size_t k : {0U, 1U})
      for (Vec2& F : of_cell(s, k, f))
        F.x() += (k == 0 ? force : -force) / static_cast<double>(s.cells[k].cortex.size());
  };
}

} // namespace

TEST(Cells, StartWhereTheScenarioPutsThem) {
  Parameters p = row_of_cells(3, 40.0);
  const State s = initial_state(p);
  ASSERT_EQ(s.cells.size(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(s.cells[k].id, k);
    EXPECT_NEAR((centroid(s.cells[k].cortex) - Vec2(p.cells[k].x, p.cells[k].y)).norm(), 0.0, 1e-9);
  }
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    for (const CellStart& start : p.cells)
      if ((s.ecm.X[i] - Vec2(start.x, start.y)).norm() < p.cell.radius) {
        EXPECT_EQ(s.ecm.f[i], 0.0);
      }
}

TEST(Cells, OneOfThemHasTheBitsOfASingleCell) {
  Parameters single;
  single.ecm.radius = 60.0;
  Parameters one = single;
  one.cells = {{0.0, 0.0}};
  EXPECT_TRUE(same_bits(initial_state(one), initial_state(single)));
}

// Cells that do not touch feel nothing of the contact, whatever its strength: not even a rounding.
TEST(Cells, HaveTheBitsOfCellsWithoutContactUntilTheyFeelEachOther) {
  Parameters p = row_of_cells(2, 36.0);
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 5.0;
  Parameters other = p;
  other.contact.cells.repulsion = 5.0;
  other.contact.cells.repulsion_range = 0.3;
  State s = initial_state(p), t = initial_state(other);
  Workspace w(s, p), w_other(t, other);
  march(s, p, w, 100.0);
  march(t, other, w_other, 100.0);
  EXPECT_TRUE(w.touches.empty());
  EXPECT_TRUE(same_bits(s, t));
}

TEST(Cells, ThatArePressedTogetherDoNotOverlap) {
  Parameters p = row_of_cells(2, 31.0);
  p.protrusion.initiation_rate = 0.0;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 5.0;
  State s = initial_state(p);
  Workspace w(s, p);
  double gap = 1.0, imbalance = 0.0;
  march(s, p, w, 600.0, press(0.5), [&](const State& now) {
    const GroupRow row = group_row(now, {}, p);
    if (row.contacts > 0) gap = std::min(gap, row.gap);
    imbalance = std::max(imbalance, force_imbalance(w));
    return true;
  });
  EXPECT_GT(gap, 0.2) << "0.5 nN in all, more than a protrusion pushes with";
  EXPECT_LT(gap, 0.99) << "they do touch";
  EXPECT_LT(imbalance, 1e-9) << "third law over matrix and cells";
  for (const Cell& cell : s.cells) EXPECT_FALSE(crosses_itself(cell.cortex));
}

TEST(Cells, ThatOverlapArePushedApart) {
  Parameters p = row_of_cells(2, 29.0); // what no scenario may ask for
  p.protrusion.initiation_rate = 0.0;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 5.0;
  State s = initial_state(p);
  Workspace w(s, p);
  const double before = group_row(s, {}, p).gap;
  march(s, p, w, 300.0);
  EXPECT_LT(before, -0.9);
  EXPECT_GT(group_row(s, {}, p).gap, 0.0);
}

TEST(Cells, ThatStickResistBeingParted) {
  Parameters p = row_of_cells(2, 31.2);
  p.protrusion.initiation_rate = 0.0;
  p.run.integrator = Integrator::adaptive;
  p.run.time_step = 5.0;
  const auto distance_after = [&](double adhesion) {
    Parameters q = p;
    q.contact.cells.adhesion = adhesion;
    State s = initial_state(q);
    Workspace w(s, q);
    march(s, q, w, 300.0, press(-0.2));
    return (centroid(s.cells[1].cortex) - centroid(s.cells[0].cortex)).norm();
  };
  const double loose = distance_after(0.0);
  EXPECT_GT(loose, 31.3);
  EXPECT_LT(distance_after(0.5), loose - 0.05);
}

TEST(Cells, InContactGoOnFromACheckpointWithTheSameBits) {
  Parameters p = row_of_cells(3, 31.0);
  p.contact.cells.adhesion = 0.1;
  p.protrusion.initiation_rate = 2e-3;
  State s = initial_state(p);
  Workspace w(s, p);
  for (int k = 0; k < 60; ++k) advance(s, p, p.run.time_step, w);
  EXPECT_FALSE(w.touches.empty());
  State read = store::parse_checkpoint(store::checkpoint_image({s, {}, {}, {}, {}}), "c.h5").state;
  EXPECT_TRUE(same_bits(read, s));
  Workspace fresh(read, p);
  for (int k = 0; k < 60; ++k) {
    advance(s, p, p.run.time_step, w);
    advance(read, p, p.run.time_step, fresh);
  }
  EXPECT_TRUE(same_bits(read, s));
}
