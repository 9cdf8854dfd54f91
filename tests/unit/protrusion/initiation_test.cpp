#include "protrusion/initiation.hpp"

#include "base/kolmogorov_smirnov.hpp"
#include "base/random.hpp"
#include "protrusion/membership.hpp"
#include "scene.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

/// Steps until the first protrusion; its time, any moment within the step as likely as for a constant rate [s].
double first_initiation(Parameters p, std::uint64_t seed, const State& start,
                        const std::vector<std::uint8_t>& of_front) {
  p.run.seed = seed;
  State s = start;
  while (s.protrusions.empty()) {
    ++s.step;
    s.t = static_cast<double>(s.step) * p.run.time_step;
    initiate(s, p, of_front, Vec2::Zero());
  }
  const double probability = event_probability(p.protrusion.initiation_rate, p.run.time_step);
  const auto n = static_cast<double>(std::ranges::count(of_front, 1));
  const double u = uniform(seed, Purpose::test, s.step, 0);
  const double within = -std::log1p(-u * -std::expm1(n * std::log1p(-probability))) / n / p.protrusion.initiation_rate;
  return s.t - p.run.time_step + within;
}

} // namespace

TEST(Initiation, WaitingTimesAreExponentialWithTheRateOfAllFrontParticles) {
  const Parameters p = small_matrix();
  State s;
  s.cortex = round_cortex(p.cell);
  std::vector<std::uint8_t> of_front(s.cortex.size(), 0);
  std::fill_n(of_front.begin(), 118, 1);
  std::vector<double> times;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) times.push_back(first_initiation(p, seed, s, of_front));
  EXPECT_LT(kolmogorov_smirnov_exponential(times, 118 * 6e-5), one_in_a_hundred);
  EXPECT_GT(kolmogorov_smirnov_exponential(times, 1.2 * 118 * 6e-5), one_in_a_hundred); // the test can fail
}

TEST(Initiation, HappensOnFrontParticlesAloneAndEachIsAsLikely) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 1e-3;
  State s;
  s.cortex = round_cortex(p.cell);
  std::vector<std::uint8_t> of_front(s.cortex.size(), 0);
  std::fill_n(of_front.begin() + 50, 100, 1);
  std::vector<double> places;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    State start = s;
    p.run.seed = seed;
    while (start.protrusions.empty()) {
      ++start.step;
      initiate(start, p, of_front, Vec2::Zero());
    }
    ASSERT_TRUE(of_front[start.protrusions[0].centre]);
    places.push_back((start.protrusions[0].centre - 50 + uniform(seed, Purpose::test, 0, 1)) / 100.0);
  }
  EXPECT_LT(kolmogorov_smirnov(places, [](double x) { return x; }), one_in_a_hundred);
}

TEST(Initiation, GrowsAwayFromTheCentreOfMassAndTheFirstSetsThePolarization) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 10.0; // all that have room, in one step
  State s = cell_in_matrix(p);
  const Vec2 centre(1.0, 2.0);
  s.t = 12.0;
  initiate(s, p, std::vector<std::uint8_t>(s.cortex.size(), 1), centre);
  ASSERT_EQ(s.protrusions.size(), 5U); // 235 particles, 41 each
  for (const Protrusion& protrusion : s.protrusions) {
    const Vec2 d = std::get<Growing>(protrusion.phase).direction;
    EXPECT_LT((d - (s.cortex.x[protrusion.centre] - centre).normalized()).norm(), 1e-12);
    EXPECT_EQ(protrusion.since, 12.0);
    EXPECT_EQ(protrusion.record.t_initiation, 12.0);
  }
  const Vec2 first = std::get<Growing>(s.protrusions[0].phase).direction;
  EXPECT_DOUBLE_EQ(*s.polarization, std::atan2(first.y(), first.x()));
  EXPECT_EQ(s.initiated, 5U);
  EXPECT_EQ(s.protrusions[4].record.id, 5U);
}

TEST(Initiation, ProtrusionsNeverShareParticles) {
  Parameters p = small_matrix();
  p.protrusion.initiation_rate = 0.05;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    p.run.seed = seed;
    State s = cell_in_matrix(p);
    for (int k = 0; k < 50; ++k) {
      ++s.step;
      initiate(s, p, std::vector<std::uint8_t>(s.cortex.size(), 1), Vec2::Zero());
    }
    const Membership m = membership(s, p);
    EXPECT_EQ(std::ranges::count_if(m.of_particle, [](int n) { return n != no_protrusion; }),
              static_cast<long>(41 * s.protrusions.size()));
  }
}

TEST(KeptNumber, IsReachedAndNeverPassed) {
  Parameters p = small_matrix();
  for (const int number : {1, 2, 3, 4}) {
    p.protrusion.number = number;
    State s = cell_in_matrix(p);
    const std::vector<std::uint8_t> of_front = front(s.cortex, 0.3);
    for (int k = 0; k < 200; ++k) {
      ++s.step;
      initiate(s, p, of_front, Vec2::Zero());
      ASSERT_LE(s.protrusions.size(), static_cast<std::size_t>(number));
    }
    EXPECT_EQ(s.protrusions.size(), static_cast<std::size_t>(number)) << number;
    s.protrusions.erase(s.protrusions.begin());
    for (int k = 0; k < 200; ++k, ++s.step) initiate(s, p, of_front, Vec2::Zero());
    EXPECT_EQ(s.protrusions.size(), static_cast<std::size_t>(number));
  }
}

TEST(KeptNumber, TakesRearParticlesAHundredTimesMoreRarely) {
  Parameters p = small_matrix();
  p.protrusion.number = 1;
  const State start = cell_in_matrix(p);
  const std::vector<std::uint8_t> of_front = front(start.cortex, 0.3);
  int rear = 0;
  constexpr int cells = 20000;
  State s = start;
  for (int n = 0; n < cells; ++n) {
    s.protrusions.clear();
    ++s.step;
    initiate(s, p, of_front, Vec2::Zero());
    ASSERT_EQ(s.protrusions.size(), 1U);
    rear += of_front[s.protrusions[0].centre] ? 0 : 1;
  }
  const double expected = 0.01 * 118.0 / (117.0 + 0.01 * 118.0);
  EXPECT_NEAR(static_cast<double>(rear) / cells, expected, 4.0 * std::sqrt(expected / cells));
}

TEST(KeptNumber, WaitsWhileTheCellIsTooLarge) {
  Parameters p = small_matrix();
  p.protrusion.number = 2;
  State s = cell_in_matrix(p);
  const std::vector<std::uint8_t> all(s.cortex.size(), 1);
  for (int k = 0; k < 50; ++k, ++s.step) initiate(s, p, all, Vec2::Zero(), 2.01);
  EXPECT_TRUE(s.protrusions.empty());
  initiate(s, p, all, Vec2::Zero(), 1.99);
  EXPECT_EQ(s.protrusions.size(), 1U);
}

TEST(HasRoom, NeedsAllParticlesFree) {
  const Parameters p = small_matrix();
  State s = cell_in_matrix(p);
  add_protrusion(s, 100, Finishing{0.5});
  const std::vector<int> of_particle = membership(s, p).of_particle;
  EXPECT_FALSE(has_room(s.cortex, 140, of_particle, p.protrusion));
  EXPECT_TRUE(has_room(s.cortex, 141, of_particle, p.protrusion));
  EXPECT_FALSE(has_room(s.cortex, 60, of_particle, p.protrusion));
  EXPECT_TRUE(has_room(s.cortex, 59, of_particle, p.protrusion));
}
