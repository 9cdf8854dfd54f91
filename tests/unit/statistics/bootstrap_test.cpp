#include "statistics/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace matrigrate::statistics {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Bootstrap, DrawsAreTheSameEachTimeAndEvenlySpread) {
  EXPECT_EQ(resampled(5, 7, 3), resampled(5, 7, 3));
  EXPECT_NE(resampled(5, 7, 3), resampled(5, 8, 3));
  EXPECT_NE(resampled(5, 7, 3), resampled(5, 7, 4));
  std::vector<double> count(5, 0.0);
  for (std::size_t draw = 0; draw < 4000; ++draw)
    for (const std::size_t i : resampled(5, 7, draw)) count.at(i) += 1.0;
  for (const double n : count) EXPECT_NEAR(n, 4000.0, 5.0 * std::sqrt(20000.0 * 0.2 * 0.8));
  EXPECT_TRUE(resampled(0, 7, 0).empty());
}

TEST(Bootstrap, TheIntervalOfAMeanIsNearThatOfTheory) {
  std::vector<double> x;
  for (int i = 0; i < 100; ++i) x.push_back(static_cast<double>(i));
  const Moments m = moments(x);
  std::vector<double> draws;
  for (std::size_t draw = 0; draw < bootstrap_draws; ++draw)
    draws.push_back(moments(picked(x, resampled(x.size(), 3, draw))).mean);
  const Interval i = percentile_interval(m.mean, draws, 0.05);
  EXPECT_NEAR(i.low, m.mean - 1.96 * m.sd / 10.0, 0.8);
  EXPECT_NEAR(i.high, m.mean + 1.96 * m.sd / 10.0, 0.8);
}

TEST(Bootstrap, DrawsThatAreNotDefinedAreLeftOut) {
  const Interval some = percentile_interval(2.0, std::vector<double>{1.0, nan, 3.0}, 0.5);
  EXPECT_EQ(some.low, 1.5);
  EXPECT_EQ(some.high, 2.5);
  EXPECT_TRUE(std::isnan(percentile_interval(2.0, std::vector<double>{1.0, nan, nan}, 0.5).low)) << "too many";
  EXPECT_TRUE(std::isnan(percentile_interval(nan, std::vector<double>{1.0, 2.0}, 0.5).low));
  EXPECT_TRUE(std::isnan(percentile_interval(2.0, {}, 0.5).high));
}

} // namespace
} // namespace matrigrate::statistics
