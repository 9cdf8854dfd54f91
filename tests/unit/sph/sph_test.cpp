#include "sph/interpolate.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"
#include "state/ecm.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

using namespace matrigrate;

namespace {

EcmState gel() { return rectangle(EcmParameters{}, 40.0, 40.0, 0.0); }
const Kernel kernel(2.6);

} // namespace

TEST(PointWeights, SumToOneWithFullSupportInside) {
  const PointWeights w = solid_weights(gel(), kernel, Vec2(0.3, -0.7));
  EXPECT_NEAR(std::accumulate(w.weight.begin(), w.weight.end(), 0.0), 1.0, 1e-14);
  EXPECT_NEAR(w.support, 1.0, 0.02);
}

TEST(PointWeights, LeaveOutFluidAndFadeWithIt) {
  EcmState ecm = gel();
  const double intact = solid_weights(ecm, kernel, Vec2::Zero()).support;
  for (std::size_t i = 0; i < ecm.size(); ++i) ecm.f[i] = ecm.X[i].x() < 0.0 ? 0.0 : 0.5;
  const PointWeights w = solid_weights(ecm, kernel, Vec2::Zero());
  for (const std::uint32_t i : w.index) EXPECT_GT(ecm.X[i].x(), 0.0);
  EXPECT_NEAR(w.support, 0.25 * intact, 1e-12);
  std::fill(ecm.f.begin(), ecm.f.end(), 0.0);
  EXPECT_EQ(solid_weights(ecm, kernel, Vec2::Zero()).support, 0.0);
}

TEST(PointWeights, SpreadAndInterpolateAreAdjoint) {
  const EcmState ecm = gel();
  const PointWeights w = solid_weights(ecm, kernel, Vec2(1.1, 0.4));
  std::vector<Vec2> force(ecm.size(), Vec2::Zero()), v(ecm.size());
  for (std::size_t i = 0; i < ecm.size(); ++i) v[i] = Vec2(0.1 * ecm.X[i].y() - 0.3, ecm.X[i].x());
  const Vec2 pull(0.4, -0.2);
  spread(w, pull, force);
  double power = 0.0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    power += force[i].dot(v[i]);
    sum += force[i];
  }
  EXPECT_NEAR(power, pull.dot(interpolate(w, v)), 1e-14);
  EXPECT_NEAR((sum - pull).norm(), 0.0, 1e-15);
}

TEST(Kernel, IntegratesToOneOverThePlane) {
  const int n = 20000;
  double sum = 0.0;
  for (int k = 0; k < n; ++k) {
    const double r = (k + 0.5) / n * kernel.support();
    sum += kernel.W(r) * 2.0 * std::numbers::pi * r * kernel.support() / n;
  }
  EXPECT_NEAR(sum, 1.0, 1e-8);
}

TEST(Kernel, SlopeIsTheDerivativeOverTheDistance) {
  const double d = 1e-6;
  for (const double r : {0.3, 1.0, 2.0, 2.6, 4.0, 5.1})
    EXPECT_NEAR(kernel.W_slope(r), (kernel.W(r + d) - kernel.W(r - d)) / (2.0 * d) / r, 1e-9);
}

TEST(Kernel, SlopeShapeIsTheSlopeOverThatAtZero) {
  for (double r = 0.0; r < 6.0; r += 0.1)
    EXPECT_NEAR(slope_shape(r, 1.0 / kernel.support()), kernel.W_slope(r) / kernel.W_slope(0.0), 1e-15) << r;
}

TEST(Kernel, VanishesSmoothlyAtTheEdgeOfItsSupport) {
  const Kernel narrow(1.3);
  EXPECT_EQ(narrow.W(narrow.support()), 0.0);
  EXPECT_EQ(narrow.W_slope(narrow.support()), 0.0);
  EXPECT_EQ(narrow.W(7.0), 0.0);
  EXPECT_GT(narrow.W(0.0), narrow.W(0.5));
  EXPECT_LT(narrow.W_slope(0.0), 0.0);
}

namespace {

std::vector<Vec2> scattered(int n, double width, double height) {
  std::vector<Vec2> x;
  for (int k = 0; k < n; ++k) {
    const double a = std::fmod(k * 0.754877666, 1.0), b = std::fmod(k * 0.569840291, 1.0);
    x.emplace_back(a * width, b * height - 0.5 * height);
  }
  return x;
}

void expect_all_pairs(const std::vector<Vec2>& x, double reach, double period) {
  const Adjacency list = neighbours_within(x, reach, period);
  ASSERT_EQ(list.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::size_t j = 0; j < x.size(); ++j)
      if (j != i && nearest_image(x[i] - x[j], period).norm() <= reach)
        expected.push_back(static_cast<std::uint32_t>(j));
    const std::vector<std::uint32_t> found(list.of(i).begin(), list.of(i).end());
    EXPECT_EQ(found, expected) << "particle " << i;
  }
}

} // namespace

TEST(Neighbours, AreThoseOfADirectSearch) { expect_all_pairs(scattered(400, 50.0, 30.0), 5.2, 0.0); }

TEST(Neighbours, AreThoseOfADirectSearchAcrossAPeriod) {
  std::vector<Vec2> x = scattered(400, 50.0, 30.0);
  for (std::size_t i = 0; i < x.size(); i += 7) x[i].x() += 150.0; // images further along count the same
  expect_all_pairs(x, 5.2, 50.0);
}

TEST(Neighbours, OfOneParticleAreNone) {
  EXPECT_EQ(neighbours_within(std::vector<Vec2>{{1.0, 2.0}}, 3.0, 0.0).pairs(), 0U);
  EXPECT_EQ(neighbours_within(std::vector<Vec2>{}, 3.0, 0.0).size(), 0U);
}

TEST(Neighbours, SurviveAStrayParticle) {
  std::vector<Vec2> x = scattered(100, 20.0, 20.0);
  x.emplace_back(1e9, -1e9);
  expect_all_pairs(x, 4.0, 0.0);
}

TEST(Neighbours, RefuseWhatCannotBeListed) {
  EXPECT_THROW(neighbours_within(scattered(10, 8.0, 8.0), 4.0, 8.0), std::invalid_argument);
  EXPECT_THROW(neighbours_within(std::vector<Vec2>{{std::numeric_limits<double>::quiet_NaN(), 0.0}}, 1.0, 0.0),
               std::invalid_argument);
}

TEST(VerletList, IsBuiltAgainBeforeAPairCanBeMissed) {
  std::vector<Vec2> x{{0.0, 0.0}, {7.0, 0.0}};
  VerletList list(5.2, 1.0);
  EXPECT_EQ(list.update(x, 0.0).size(), 2U);
  EXPECT_EQ(list.pairs().pairs(), 0U);
  int builds = 0;
  for (int step = 0; step < 40; ++step) { // both approach, 0.1 um a step together
    x[0].x() += 0.05;
    x[1].x() -= 0.05;
    if (!list.update(x, 0.0).empty()) ++builds;
    if ((x[1] - x[0]).norm() <= 5.2) {
      EXPECT_EQ(list.pairs().pairs(), 2U);
    }
  }
  EXPECT_GE(builds, 2);
  EXPECT_LE(builds, 5);
}

TEST(VerletList, MendedWhereParticlesMoveIsAsBuiltThere) {
  for (const double period : {0.0, 50.0}) {
    std::vector<Vec2> x = scattered(1000, 50.0, 60.0);
    constexpr double reach = 4.0, skin = 0.5;
    VerletList list(reach, skin);
    list.update(x, period);
    std::size_t mended = 0;
    for (int step = 0; step < 60; ++step) { // one swims through the others, a few shake
      x[17] += Vec2(0.1, 0.07);
      for (std::size_t k = 100; k < 110; ++k) x[k].x() += 0.04 * std::sin(0.2 * step + static_cast<double>(k));
      const Adjacency before = list.pairs();
      const auto changed = list.update(x, period);
      const Adjacency within = neighbours_within(x, reach, period);
      std::size_t kept = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        const auto row = list.pairs().of(i);
        EXPECT_TRUE(std::ranges::is_sorted(row));
        EXPECT_TRUE(std::ranges::includes(row, within.of(i))) << "particle " << i << ", step " << step;
        for (const std::uint32_t j : row) { // symmetric, and no further than it ever reaches
          EXPECT_TRUE(std::ranges::binary_search(list.pairs().of(j), static_cast<std::uint32_t>(i)));
          EXPECT_LE(nearest_image(x[i] - x[j], period).norm(), reach + 2.0 * skin);
        }
        if (!changed.empty() && changed[i] == 0) {
          EXPECT_TRUE(std::ranges::equal(row, before.of(i)));
          ++kept;
        }
      }
      if (kept > 0) ++mended;
    }
    EXPECT_GE(mended, 10U);
  }
}

TEST(VerletList, FindsRoomWhereParticlesGather) {
  std::vector<Vec2> x = scattered(2000, 100.0, 100.0);
  constexpr double reach = 4.0, skin = 0.5;
  VerletList list(reach, skin);
  list.update(x, 0.0);
  for (std::size_t k = 0; k < 40; ++k) { // around one whose row has not as much room
    x[50 * k] = x[7] + 0.05 * Vec2(static_cast<double>(k % 7), static_cast<double>(k % 5));
    list.update(x, 0.0);
    const Adjacency within = neighbours_within(x, reach, 0.0);
    for (std::size_t i = 0; i < x.size(); ++i)
      ASSERT_TRUE(std::ranges::includes(list.pairs().of(i), within.of(i))) << "particle " << i << ", " << k;
  }
  EXPECT_GE(list.pairs().of(7).size(), 39U);
}

TEST(VerletList, IsBuiltEverywhereWhereAllMove) {
  std::vector<Vec2> x = scattered(100, 20.0, 20.0);
  VerletList list(4.0, 0.5);
  list.update(x, 0.0);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] *= 1.1;
  const auto changed = list.update(x, 0.0);
  EXPECT_EQ(std::ranges::count(changed, 1), 100);
  const Adjacency all = neighbours_within(x, 4.5, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_TRUE(std::ranges::equal(list.pairs().of(i), all.of(i))) << "particle " << i;
}
