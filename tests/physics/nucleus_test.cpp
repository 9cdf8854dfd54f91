#include "cell/geometry.hpp"
#include "cell/nucleus.hpp"
#include "contact/nucleus.hpp"
#include "gel.hpp"
#include "observe/health.hpp"
#include "parameters/read.hpp"
#include "simulation/advance.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "state/dof.hpp"
#include "store/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

using namespace matrigrate;

namespace nucleus_test {

namespace {

Parameters with_nucleus(std::vector<std::string> more = {}) {
  std::vector<std::string> overrides{"run.integrator=adaptive", "ecm.radius=70 um", "nucleus.radius=5 um"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return apply_overrides({}, overrides, start_rules());
}

/// Presses cells flat from above and below.   @param force  from either side [nN]
Loads press(double force) {
  return [force](const State& s, std::span<Vec2> f) {
    for (std::size_t k = 0; k < s.cells.size(); ++k) {
      const CortexState& c = s.cells[k].cortex;
      const double middle = centroid(c).y();
      const std::span<Vec2> of_cortex = of_cell(s, k, f);
      for (std::size_t i = 0; i < c.size(); ++i)
        of_cortex[i].y() -= (c.x[i].y() > middle ? 2.0 : -2.0) * force / static_cast<double>(c.size());
    }
  };
}

double height(const CortexState& c) {
  const auto [low, high] = std::ranges::minmax_element(c.x, {}, [](const Vec2& x) { return x.y(); });
  return high->y() - low->y();
}

/// A small cell that is pressed and begins no protrusions.
Parameters pressed(double radius) {
  return with_nucleus(
      {"cell.radius=7 um", "nucleus.radius=" + std::to_string(radius) + " um", "protrusion.initiation_rate=0 1/s"});
}

} // namespace

TEST(NucleusOfACell, StaysInsideAndKeepsItsAreaUnderPressure) {
  const Parameters p = pressed(5.0);
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 300.0, press(6.0));
  const Cell& cell = s.cells[0];
  EXPECT_LT(height(cell.nucleus), 9.0) << "it is pressed flat";
  EXPECT_GT(aspect_ratio(cell.nucleus), 1.15);
  EXPECT_NEAR(area(cell.nucleus) / initial_area(lamina(p)), 1.0, 0.1);
  EXPECT_FALSE(nucleus_outside(cell));
  EXPECT_FALSE(crosses_itself(cell.nucleus));
  EXPECT_GT(height(cell.cortex), height(cell.nucleus));
}

TEST(NucleusOfACell, HoldsThePressedCellOpen) {
  const auto pressed_height = [](double radius) {
    const Parameters p = pressed(radius);
    State s = initial_state(p);
    Workspace w(s, p);
    march(s, p, w, 300.0, press(6.0));
    return height(s.cells[0].cortex);
  };
  EXPECT_GT(pressed_height(5.0), pressed_height(0.0) + 1.0);
}

TEST(NucleusOfACell, FeelsNoForceFromOutside) {
  const Parameters p = pressed(5.0);
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 60.0, press(6.0));
  const std::vector<Vec2>& F = w.force;
  const Vec2 sum = std::accumulate(F.begin(), F.end(), Vec2(0.0, 0.0)) - w.outer_force;
  double magnitude = 0.0;
  for (const Vec2& f : F) magnitude += f.norm();
  const auto on_nucleus = of_nucleus(s, 0, std::span(F));
  EXPECT_GT(std::ranges::max(on_nucleus, {}, [](const Vec2& f) { return f.norm(); }).norm(), 1e-4);
  double of_matrix = 0.0; // clamped particles take up what the rim holds
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (s.ecm.clamped[i] != 0) of_matrix += F[i].norm();
  EXPECT_LT(sum.norm(), 1e-12 * (magnitude + of_matrix));
}

TEST(NucleusOfACell, GoesWithAMigratingCell) {
  const Parameters p = with_nucleus({"protrusion.initiation_rate=5e-4 1/s", "protrusion.growth_time=200 s"});
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 900.0);
  EXPECT_GE(s.cells[0].initiated, 2U);
  EXPECT_LT(off_centre(s.cells[0]).norm(), 5.0);
  EXPECT_GT(centroid(s.cells[0].nucleus).norm(), 1e-3) << "it has moved";
  EXPECT_NEAR(area(s.cells[0].nucleus) / initial_area(lamina(p)), 1.0, 0.05);
}

TEST(NucleusOfACell, GoesOnFromACheckpointWithTheSameBits) {
  Parameters p = with_nucleus({"ecm.radius=90 um"});
  p.cells = {{-20.0, 0.0}, {20.0, 0.0}};
  State s = initial_state(p);
  ASSERT_EQ(s.cells[1].nucleus.size(), 72U);
  Workspace w(s, p);
  march(s, p, w, 60.0, press(2.0));
  State read = store::parse_checkpoint(store::checkpoint_image({s, {}, {}, {}, {}}), "c.h5").state;
  ASSERT_TRUE(same_bits(read, s));
  ASSERT_EQ(read.cells[1].nucleus.x, s.cells[1].nucleus.x);
  Workspace fresh(read, p);
  march(s, p, w, 120.0, press(2.0));
  march(read, p, fresh, 120.0, press(2.0));
  EXPECT_TRUE(same_bits(read, s));
}

TEST(NucleusOfACell, IsMissedByTheAlarmOnlyWhileItIsInside) {
  const Parameters p = with_nucleus();
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 5.0);
  HealthRow row;
  row.area_ratio = 1.0;
  EXPECT_FALSE(alarm(s, p, row));
  for (Vec2& x : s.cells[0].nucleus.x) x.x() += 12.0;
  const std::optional<Alarm> found = alarm(s, p, row);
  ASSERT_TRUE(found);
  EXPECT_EQ(to_string(found->cause), "nucleus_outside") << found->text;
}

} // namespace nucleus_test
