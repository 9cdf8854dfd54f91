#include "cell/geometry.hpp"
#include "protrusion/initiation.hpp"
#include "scene.hpp"
#include "statistics/kolmogorov_smirnov.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

// A hundred particles of propensity 3 and fifty of propensity 1 have the rate of 350; the others, of none, stay quiet.
TEST(Propensity, IsAFactorOnTheRateOfAParticle) {
  Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  std::vector<double> propensity(all.size(), 0.0);
  std::fill_n(propensity.begin(), 100, 3.0);
  std::fill_n(propensity.begin() + 100, 50, 1.0);
  std::vector<double> times;
  double of_first = 0.0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    p.run.seed = seed;
    Scene at = s;
    while (at.cell.protrusions.empty()) {
      next_step(at, p);
      initiate(at.cell, at.now, p, p.run.time_step, {.of_front = all, .normals = n, .propensity = propensity});
    }
    const std::uint32_t centre = at.cell.protrusions[0].centre;
    ASSERT_LT(centre, 150U);
    of_first += centre < 100 ? 1e-3 : 0.0;
    times.push_back(at.now.t - 0.5 * p.run.time_step);
  }
  EXPECT_LT(kolmogorov_smirnov_exponential(times, 350 * 6e-5), one_in_a_hundred);
  EXPECT_NEAR(of_first, 300.0 / 350.0, 4.0 * std::sqrt(300.0 * 50.0) / 350.0 / std::sqrt(1000.0));
}

TEST(Propensity, OfOneChangesNothing) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 1e-3;
  const Scene start = cell_in_matrix(p);
  const std::vector<std::uint8_t> of_front = front(start.cell.cortex, 0.3);
  const std::vector<Vec2> n = normals(start.cell.cortex);
  const std::vector<double> one(of_front.size(), 1.0);
  for (const int number : {0, 2}) {
    p.protrusion.number = number;
    Scene plain = start;
    Scene s = start;
    for (int k = 0; k < 400; ++k) {
      next_step(plain, p);
      initiate(plain.cell, plain.now, p, p.run.time_step, {.of_front = of_front, .normals = n});
      initiate(s.cell, plain.now, p, p.run.time_step, {.of_front = of_front, .normals = n, .propensity = one});
    }
    ASSERT_FALSE(s.cell.protrusions.empty());
    ASSERT_EQ(s.cell.protrusions.size(), plain.cell.protrusions.size());
    for (std::size_t k = 0; k < s.cell.protrusions.size(); ++k) {
      EXPECT_EQ(s.cell.protrusions[k].centre, plain.cell.protrusions[k].centre);
      EXPECT_EQ(s.cell.protrusions[k].since, plain.cell.protrusions[k].since);
    }
  }
}

TEST(Propensity, OfZeroLeavesNoCandidate) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<double> none(all.size(), 0.0);
  for (int k = 0; k < 100; ++k) {
    next_step(s, p);
    initiate(s.cell, s.now, p, p.run.time_step, {.of_front = all, .normals = n, .propensity = none});
  }
  EXPECT_TRUE(s.cell.protrusions.empty());
}

TEST(Propensity, DecidesAmongTheCandidatesOfAKeptNumber) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  const std::vector<Vec2> n = normals(s.cell.cortex);
  std::vector<double> propensity(all.size(), 0.0);
  propensity[40] = 2.0;
  propensity[70] = 6.0;
  int of_second = 0;
  constexpr int cells = 2000;
  for (int k = 0; k < cells; ++k) {
    s.cell.protrusions.clear();
    next_step(s, p);
    initiate(s.cell, s.now, p, p.run.time_step, {.of_front = all, .normals = n, .propensity = propensity});
    ASSERT_EQ(s.cell.protrusions.size(), 1U);
    ASSERT_TRUE(s.cell.protrusions[0].centre == 40 || s.cell.protrusions[0].centre == 70);
    of_second += s.cell.protrusions[0].centre == 70 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(of_second) / cells, 0.75, 4.0 * std::sqrt(0.75 * 0.25 / cells));
}
