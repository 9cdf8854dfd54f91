#include "cell/geometry.hpp"
#include "gel.hpp"
#include "parameters/read.hpp"
#include "simulation/march.hpp"
#include "simulation/start.hpp"
#include "store/checkpoint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace matrigrate;

namespace {

/// A cell that grows one protrusion after the other between two walls, 40 um apart.
Parameters walled(std::vector<std::string> more = {}) {
  std::vector<std::string> overrides{"run.integrator=adaptive", "ecm.radius=70 um",
                                     "ecm.fields.obstacle=abs(y) > 20 && abs(y) < 28 ? 1 : 0",
                                     "protrusion.initiation_rate=5e-4 1/s", "protrusion.growth_time=200 s"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return apply_overrides({}, overrides, start_rules());
}

} // namespace

TEST(Obstacles, HoldTheCellBetweenThem) {
  const Parameters p = walled();
  State s = initial_state(p);
  const EcmState before = s.ecm;
  Workspace w(s, p);
  march(s, p, w, 900.0);
  EXPECT_GE(s.cells[0].initiated, 2U);
  double highest = 0.0;
  for (const Vec2& x : s.cells[0].cortex.x) highest = std::max(highest, std::abs(x.y()));
  EXPECT_GT(highest, 18.5) << "a protrusion has come to a wall";
  EXPECT_LT(highest, 22.0) << "the particles of the first row lie at 22 um";
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    if (!s.ecm.in_obstacle(i)) continue;
    EXPECT_EQ(s.ecm.x[i], before.X[i]);
    EXPECT_EQ(s.ecm.f[i], 1.0);
  }
  EXPECT_FALSE(crosses_itself(s.cells[0].cortex));
}

TEST(Obstacles, GoOnFromACheckpointWithTheSameBits) {
  const Parameters p = walled();
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 60.0);
  State read = store::parse_checkpoint(store::checkpoint_image({s, {}, {}, {}, {}}), "c.h5").state;
  Workspace fresh(read, p);
  march(s, p, w, 120.0);
  march(read, p, fresh, 120.0);
  EXPECT_TRUE(same_bits(read, s));
}

// A pillar in uniform matrix that is not touched leaves all at rest.
TEST(Obstacles, AreFreeOfStressAtTheStart) {
  const Parameters p = walled({"protrusion.initiation_rate=0 1/s", "actomyosin.force=0 nN"});
  State s = initial_state(p);
  Workspace w(s, p);
  march(s, p, w, 60.0);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) EXPECT_LT(s.ecm.S[i].norm(), 1e-3) << s.ecm.X[i].transpose();
}
