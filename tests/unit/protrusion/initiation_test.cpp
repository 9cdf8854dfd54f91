#include "protrusion/initiation.hpp"

#include "base/random.hpp"
#include "cell/geometry.hpp"
#include "protrusion/membership.hpp"
#include "scene.hpp"
#include "statistics/distributions.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

using namespace matrigrate;

namespace {

void try_to_initiate(Scene& s, const Parameters& p, const std::vector<std::uint8_t>& of_front,
                     const Vec2& centre = Vec2::Zero(), double area = 1.0) {
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<double> rate(of_front.size(), p.protrusion.initiation_rate);
  initiate(s.cell, s.now, p, p.run.time_step, {of_front, n, centre, area, rate});
}

/// Steps until the first protrusion; its time, any moment within the step as likely as for a constant rate [s].
double first_initiation(Parameters p, std::uint64_t seed, const Scene& start,
                        const std::vector<std::uint8_t>& of_front) {
  p.run.seed = seed;
  Scene s = start;
  while (s.cell.protrusions.empty()) {
    ++s.now.step;
    s.now.t = static_cast<double>(s.now.step) * p.run.time_step;
    try_to_initiate(s, p, of_front);
  }
  const double probability = event_probability(p.protrusion.initiation_rate, p.run.time_step);
  const auto n = static_cast<double>(std::ranges::count(of_front, 1));
  const double u = uniform(seed, Purpose::test, s.now.step, 0);
  const double within = -std::log1p(-u * -std::expm1(n * std::log1p(-probability))) / n / p.protrusion.initiation_rate;
  return s.now.t - p.run.time_step + within;
}

} // namespace

TEST(Initiation, WaitingTimesAreExponentialWithTheRateOfAllFrontParticles) {
  const Parameters p = small_matrix();
  Scene s;
  s.cell.cortex = round_cortex(p.cell);
  std::vector<std::uint8_t> of_front(s.cell.cortex.size(), 0);
  std::fill_n(of_front.begin(), 118, 1);
  std::vector<double> times;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) times.push_back(first_initiation(p, seed, s, of_front));
  EXPECT_LT(kolmogorov_smirnov_exponential(times, 118 * 6e-5), one_in_a_hundred);
  EXPECT_GT(kolmogorov_smirnov_exponential(times, 1.2 * 118 * 6e-5), one_in_a_hundred); // the test can fail
}

TEST(Initiation, HappensOnFrontParticlesAloneAndEachIsAsLikely) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 1e-3;
  Scene s;
  s.cell.cortex = round_cortex(p.cell);
  std::vector<std::uint8_t> of_front(s.cell.cortex.size(), 0);
  std::fill_n(of_front.begin() + 50, 100, 1);
  std::vector<double> places;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Scene start = s;
    p.run.seed = seed;
    while (start.cell.protrusions.empty()) {
      ++start.now.step;
      try_to_initiate(start, p, of_front);
    }
    ASSERT_TRUE(of_front[start.cell.protrusions[0].centre]);
    places.push_back((start.cell.protrusions[0].centre - 50 + uniform(seed, Purpose::test, 0, 1)) / 100.0);
  }
  EXPECT_LT(kolmogorov_smirnov(places, [](double x) { return x; }), one_in_a_hundred);
}

TEST(Initiation, GrowsAwayFromTheCentreOfMassAndTheFirstSetsThePolarization) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 10.0; // all that have room, in one step
  Scene s = cell_in_matrix(p);
  const Vec2 centre(1.0, 2.0);
  s.now.t = 12.0;
  try_to_initiate(s, p, std::vector<std::uint8_t>(s.cell.cortex.size(), 1), centre);
  ASSERT_EQ(s.cell.protrusions.size(), 5U); // 235 particles, 41 each
  for (const Protrusion& protrusion : s.cell.protrusions) {
    const Vec2 d = std::get<Growing>(protrusion.phase).direction;
    EXPECT_LT((d - (s.cell.cortex.x[protrusion.centre] - centre).normalized()).norm(), 1e-12);
    EXPECT_EQ(protrusion.since, 12.0);
    EXPECT_EQ(protrusion.record.t_initiation, 12.0);
  }
  const Vec2 first = std::get<Growing>(s.cell.protrusions[0].phase).direction;
  EXPECT_DOUBLE_EQ(*s.cell.polarization, std::atan2(first.y(), first.x()));
  EXPECT_EQ(s.cell.initiated, 5U);
  EXPECT_EQ(s.cell.protrusions[4].record.id, 5U);
}

TEST(Initiation, ProtrusionsNeverShareParticles) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 0.05;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    p.run.seed = seed;
    Scene s = cell_in_matrix(p);
    for (int k = 0; k < 50; ++k) {
      ++s.now.step;
      try_to_initiate(s, p, std::vector<std::uint8_t>(s.cell.cortex.size(), 1));
    }
    const Membership m = membership(s.cell, p);
    EXPECT_EQ(std::ranges::count_if(m.of_particle, [](int n) { return n != no_protrusion; }),
              static_cast<long>(41 * s.cell.protrusions.size()));
  }
}

TEST(Initiation, OfEachCellDrawsItsOwnNumbers) {
  const Parameters p = small_matrix();
  const auto first = [&](std::uint32_t id) {
    Scene s = cell_in_matrix(p);
    s.cell.id = id;
    while (s.cell.protrusions.empty()) {
      next_step(s, p);
      try_to_initiate(s, p, std::vector<std::uint8_t>(s.cell.cortex.size(), 1));
    }
    return std::pair(s.now.step, s.cell.protrusions[0].centre);
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(0));
  EXPECT_NE(first(1), first(2));
}

TEST(KeptNumber, IsReachedAndNeverPassed) {
  Parameters p = small_matrix();
  for (const int number : {1, 2, 3, 4}) {
    p.protrusion.number = number;
    Scene s = cell_in_matrix(p);
    const std::vector<std::uint8_t> of_front = front(s.cell.cortex, 0.3);
    for (int k = 0; k < 200; ++k) {
      next_step(s, p);
      try_to_initiate(s, p, of_front);
      ASSERT_LE(s.cell.protrusions.size(), static_cast<std::size_t>(number));
    }
    EXPECT_EQ(s.cell.protrusions.size(), static_cast<std::size_t>(number)) << number;
    s.cell.protrusions.erase(s.cell.protrusions.begin());
    for (int k = 0; k < 200; ++k) {
      next_step(s, p);
      try_to_initiate(s, p, of_front);
    }
    EXPECT_EQ(s.cell.protrusions.size(), static_cast<std::size_t>(number));
  }
}

TEST(KeptNumber, TakesRearParticlesAHundredTimesMoreRarely) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  const Scene start = cell_in_matrix(p);
  const std::vector<std::uint8_t> of_front = front(start.cell.cortex, 0.3);
  int rear = 0;
  constexpr int cells = 20000;
  Scene s = start;
  for (int n = 0; n < cells; ++n) {
    s.cell.protrusions.clear();
    next_step(s, p);
    try_to_initiate(s, p, of_front);
    ASSERT_EQ(s.cell.protrusions.size(), 1U);
    rear += of_front[s.cell.protrusions[0].centre] ? 0 : 1;
  }
  const double expected = 0.01 * 118.0 / (117.0 + 0.01 * 118.0);
  EXPECT_NEAR(static_cast<double>(rear) / cells, expected, 4.0 * std::sqrt(expected / cells));
}

TEST(KeptNumber, WaitsWhileTheCellIsTooLarge) {
  Parameters p = small_matrix();
  p.protrusion.number = 2;
  Scene s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  for (int k = 0; k < 50; ++k) {
    next_step(s, p);
    try_to_initiate(s, p, all, Vec2::Zero(), 2.01);
  }
  EXPECT_TRUE(s.cell.protrusions.empty());
  next_step(s, p);
  try_to_initiate(s, p, all, Vec2::Zero(), 1.99);
  EXPECT_EQ(s.cell.protrusions.size(), 1U);
}

TEST(KeptNumber, CountsFinishingProtrusions) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Finishing{0.5});
  for (int k = 0; k < 50; ++k) {
    next_step(s, p);
    try_to_initiate(s, p, std::vector<std::uint8_t>(s.cell.cortex.size(), 1));
  }
  EXPECT_EQ(s.cell.protrusions.size(), 1U);
  s.cell.protrusions.clear();
  next_step(s, p);
  try_to_initiate(s, p, std::vector<std::uint8_t>(s.cell.cortex.size(), 1));
  EXPECT_EQ(s.cell.protrusions.size(), 1U);
}

// Twenty eligible particles of the rear, each drawn with probability 0.01/(117 + 0.01 x 118) in each 0.4 s.
TEST(KeptNumber, WaitsAsLongWhateverTheStep) {
  const auto mean_wait = [](double dt) {
    Parameters p = small_matrix();
    p.protrusion.number = 4;
    p.run.time_step = dt;
    const Scene start = cell_in_matrix(p);
    const std::vector<std::uint8_t> of_front = front(start.cell.cortex, 0.0);
    Scene held = start; // the front is full, and most of the rear
    for (const std::size_t centre : {0U, 41U, 194U}) add_protrusion(held, centre, Finishing{0.5});
    double sum = 0.0;
    constexpr int cells = 200;
    for (int n = 0; n < cells; ++n) {
      p.run.seed = static_cast<std::uint64_t>(n);
      Scene s = held;
      while (s.cell.protrusions.size() < 4) {
        next_step(s, p);
        try_to_initiate(s, p, of_front);
      }
      sum += s.now.t;
    }
    return sum / cells;
  };
  const double at_04 = mean_wait(0.4);
  EXPECT_NEAR(mean_wait(2.4), at_04, 2.4); // the same draws, seen at the end of a step
  EXPECT_NEAR(mean_wait(0.1), at_04, 0.4);
}

TEST(HasRoom, NeedsAllParticlesFree) {
  const Parameters p = small_matrix();
  Scene s = cell_in_matrix(p);
  add_protrusion(s, 100, Finishing{0.5});
  const std::vector<int> of_particle = membership(s.cell, p).of_particle;
  EXPECT_FALSE(has_room(s.cell.cortex, 140, of_particle, p.protrusion));
  EXPECT_TRUE(has_room(s.cell.cortex, 141, of_particle, p.protrusion));
  EXPECT_FALSE(has_room(s.cell.cortex, 60, of_particle, p.protrusion));
  EXPECT_TRUE(has_room(s.cell.cortex, 59, of_particle, p.protrusion));
}

TEST(Facing, IsOneOnARoundCellAndFallsWithTheAngleOfTheNormal) {
  const Parameters p = small_matrix();
  Scene s;
  s.cell.cortex = round_cortex(p.cell);
  const std::vector<std::uint8_t> all(s.cell.cortex.size(), 1);
  std::vector<Vec2> n = normals(s.cell.cortex);
  EXPECT_NEAR(facing(s.cell.cortex, 50, {.of_front = all, .normals = n, .rate = {}}, p.protrusion), 1.0, 0.01);
  for (Vec2& normal : n) normal = Eigen::Rotation2Dd(std::numbers::pi / 3.0) * normal;
  EXPECT_NEAR(facing(s.cell.cortex, 50, {.of_front = all, .normals = n, .rate = {}}, p.protrusion), 0.5, 0.02);
  for (Vec2& normal : n) normal = Eigen::Rotation2Dd(std::numbers::pi / 2.0) * normal; // now 150 degrees
  EXPECT_EQ(facing(s.cell.cortex, 50, {.of_front = all, .normals = n, .rate = {}}, p.protrusion), 0.0);
}

TEST(Facing, KeepsProtrusionsFromBeginningWhereTheTipFacesAway) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 10.0; // all that may, in one step
  const Scene start = cell_in_matrix(p);
  const auto n = [&] {
    std::vector<Vec2> turned = normals(start.cell.cortex);
    for (std::size_t i = 0; i < 120; ++i) turned[i] = Eigen::Rotation2Dd(1.2) * turned[i]; // n . d = 0.36
    return turned;
  }();
  const std::vector<std::uint8_t> all(start.cell.cortex.size(), 1);
  const std::vector<double> rate(all.size(), p.protrusion.initiation_rate);
  const auto centres = [&](double least, int number) {
    p.protrusion.least_facing = least;
    p.protrusion.number = number;
    Scene s = start;
    for (int k = 0; k < 500; ++k) {
      next_step(s, p);
      initiate(s.cell, s.now, p, p.run.time_step, {.of_front = all, .normals = n, .rate = rate});
    }
    std::vector<std::uint32_t> found;
    for (const Protrusion& protrusion : s.cell.protrusions) found.push_back(protrusion.centre);
    return found;
  };
  const auto in_turned = [](std::uint32_t centre) { return centre < 117; };
  EXPECT_TRUE(std::ranges::any_of(centres(0.0, 0), in_turned));
  EXPECT_TRUE(std::ranges::none_of(centres(0.7, 0), in_turned));
  EXPECT_TRUE(std::ranges::any_of(centres(0.0, 4), in_turned));
  EXPECT_TRUE(std::ranges::none_of(centres(0.7, 4), in_turned));
}
