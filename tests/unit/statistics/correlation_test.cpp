#include "statistics/correlation.hpp"

#include "statistics/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace matrigrate::statistics {
namespace {

// Hollander and Wolfe 1973, p. 187, as in R's help of cor.test.
const std::vector<double> x{44.4, 45.9, 41.9, 53.3, 44.7, 44.1, 50.7, 45.2, 60.1};
const std::vector<double> y{2.6, 3.1, 2.5, 5.0, 3.6, 4.0, 5.2, 2.8, 3.8};

TEST(Correlation, AsInR) { // R: cor.test(x, y)
  const Correlation c = pearson(x, y);
  EXPECT_EQ(c.n, 9U);
  EXPECT_NEAR(c.r, 0.5711816, 1e-7);
  EXPECT_NEAR(c.p, 0.1082, 5e-5);
  EXPECT_NEAR(correlation_interval(c, 0.05).low, -0.1497426, 1e-7);
  EXPECT_NEAR(correlation_interval(c, 0.05).high, 0.8955795, 1e-7);
  EXPECT_TRUE(std::isnan(correlation_interval({3, 0.5, 0.7}, 0.05).low));
  EXPECT_TRUE(std::isnan(correlation_interval({9, 1.0, 0.0}, 0.05).low));
}

TEST(Correlation, LeavesOutPairsWithAGap) {
  std::vector<double> longer_x = x;
  std::vector<double> longer_y = y;
  longer_x.push_back(1.0);
  longer_y.push_back(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(pearson(longer_x, longer_y).r, pearson(x, y).r);
  EXPECT_EQ(pearson(longer_x, longer_y).n, 9U);
}

TEST(Correlation, WhatIsNotDefinedIsNaN) {
  EXPECT_TRUE(std::isnan(pearson({}, {}).r));
  EXPECT_TRUE(std::isnan(pearson(std::vector{1.0, 1.0, 1.0}, std::vector{1.0, 2.0, 3.0}).r));
  EXPECT_TRUE(std::isnan(pearson(std::vector{1.0, 2.0}, std::vector{1.0, 2.0}).p));
  EXPECT_EQ(pearson(std::vector{1.0, 2.0, 3.0}, std::vector{2.0, 4.0, 6.0}).p, 0.0);
  EXPECT_THROW(pearson(x, std::vector{1.0}), std::invalid_argument);
}

TEST(Correlation, SpearmanIsThatOfRanks) {
  const std::vector<double> given{1, 2, 3, 4, 5};
  EXPECT_DOUBLE_EQ(spearman(given, std::vector<double>{1, 8, 27, 64, 1000}).r, 1.0);
  // R: cor(c(1,2,3,4,5), c(2,1,4,4,7), method = "spearman")
  EXPECT_NEAR(spearman(given, std::vector<double>{2, 1, 4, 4, 7}).r, 0.8720816, 1e-6);
}

TEST(Correlation, WithinGroupsIgnoresWhatDiffersBetweenThem) {
  const std::vector<std::size_t> group{0, 0, 0, 1, 1, 1};
  const std::vector<double> given{1, 2, 3, 101, 102, 103};
  EXPECT_DOUBLE_EQ(pearson_within(given, std::vector<double>{3, 2, 1, 203, 202, 201}, group).r, -1.0);
  EXPECT_TRUE(std::isnan(pearson_within(given, std::vector<double>{0.1, 0.1, 0.1, 3, 3, 3}, group).r)) << "was set";
  const Correlation c = pearson_within(given, std::vector<double>{1, 3, 2, 50, 51, 52}, group);
  EXPECT_NEAR(c.r, 0.75, 1e-12);
  EXPECT_NEAR(c.p, t_two_sided(0.75 * std::sqrt(3.0 / (1.0 - 0.75 * 0.75)), 3.0), 1e-12);
}

} // namespace
} // namespace matrigrate::statistics
