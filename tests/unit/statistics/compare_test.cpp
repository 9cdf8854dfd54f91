#include "statistics/compare.hpp"

#include "samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace matrigrate::statistics {
namespace {

const std::vector<double> none{};
const std::vector<double> one{1.0};
const std::vector<double> same{2.0, 2.0, 2.0};

TEST(Compare, StudentsDataAsInR) { // R 4: t.test(extra ~ group, sleep, var.equal = TRUE), the sign turned
  const TestResult pooled = t_test(sleep_1, sleep_2);
  EXPECT_NEAR(pooled.statistic, 1.8608, 5e-5);
  EXPECT_EQ(pooled.df, 18.0);
  EXPECT_NEAR(pooled.p, 0.07919, 5e-6);
  const Interval difference = mean_difference(sleep_1, sleep_2, 0.05);
  EXPECT_NEAR(difference.value, 1.58, 1e-12);
  EXPECT_NEAR(difference.low, -0.203874, 1e-6);
  EXPECT_NEAR(difference.high, 3.363874, 1e-6);
}

TEST(Compare, WelchAsInR) { // R 4: t.test(extra ~ group, sleep)
  const TestResult welch = welch_test(sleep_1, sleep_2);
  EXPECT_NEAR(welch.statistic, 1.8608, 5e-5);
  EXPECT_NEAR(welch.df, 17.776, 5e-4);
  EXPECT_NEAR(welch.p, 0.07939, 5e-6);
  EXPECT_NEAR(mean_difference(sleep_1, sleep_2, 0.05, false).high, 3.3654832, 1e-6);
}

TEST(Compare, RanksAsInR) {
  // R 4: wilcox.test(extra ~ group, sleep): ties, so normal with continuity correction
  const TestResult ties = mann_whitney_test(sleep_2, sleep_1);
  EXPECT_EQ(ties.statistic, 25.5);
  EXPECT_NEAR(ties.p, 0.06933, 5e-6);
  // Hollander and Wolfe 1973, p. 69, as in R's help of wilcox.test: W = 35, one-sided p 0.1272
  const std::vector<double> x{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46};
  const std::vector<double> y{1.15, 0.88, 0.90, 0.74, 1.21};
  const TestResult exact = mann_whitney_test(y, x);
  EXPECT_EQ(exact.statistic, 35.0);
  EXPECT_NEAR(exact.p, 2.0 * 0.1272, 1e-4);
}

TEST(Compare, RanksOfAFewValuesAreCounted) { // 3 against 3 apart: 2 of 20 arrangements
  EXPECT_NEAR(mann_whitney_test(std::vector{1.0, 2.0, 3.0}, std::vector{4.0, 5.0, 6.0}).p, 0.1, 1e-12);
  EXPECT_NEAR(mann_whitney_test(std::vector{1.0, 3.0}, std::vector{2.0, 4.0}).p, 4.0 / 6.0, 1e-12);
}

TEST(Compare, RanksDoNotHangOnTheLastBit) {
  const std::vector<double> low{0.05, 0.1, 0.15, 0.2};
  const std::vector<double> tied{0.15, 0.25, 0.3, 0.35};
  std::vector<double> off = tied;
  off[0] = 0.15000000000000002;
  EXPECT_EQ(mann_whitney_test(low, off).statistic, mann_whitney_test(low, tied).statistic);
  EXPECT_EQ(mann_whitney_test(low, off).p, mann_whitney_test(low, tied).p);
  off[0] = 0.15000000001; // a difference of the eleventh digit is one
  EXPECT_NE(mann_whitney_test(low, off).statistic, mann_whitney_test(low, tied).statistic);
  for (const double scale : {1e-300, -1e-12, 1e15, 1e300}) {
    const std::vector<double> a{1.0 * scale, 2.0 * scale, 3.0 * scale};
    const std::vector<double> b{4.0 * scale, 5.0 * scale, 6.0 * scale};
    EXPECT_NEAR(mann_whitney_test(a, b).p, 0.1, 1e-12) << scale;
  }
}

TEST(Compare, SwappingTheSamplesTurnsTheSign) {
  EXPECT_DOUBLE_EQ(t_test(sleep_1, sleep_2).statistic, -t_test(sleep_2, sleep_1).statistic);
  EXPECT_DOUBLE_EQ(t_test(sleep_1, sleep_2).p, t_test(sleep_2, sleep_1).p);
  EXPECT_NEAR(mann_whitney_test(sleep_1, sleep_2).p, mann_whitney_test(sleep_2, sleep_1).p, 1e-14);
  const Interval there = hedges_g(sleep_1, sleep_2, 0.05);
  const Interval back = hedges_g(sleep_2, sleep_1, 0.05);
  EXPECT_DOUBLE_EQ(there.value, -back.value);
  EXPECT_NEAR(there.low, -back.high, 1e-8);
}

TEST(Compare, WhatIsNotDefinedIsNaN) {
  for (const auto& [a, b] : {std::pair{none, none}, {none, same}, {one, sleep_1}, {one, one}, {same, same}}) {
    EXPECT_TRUE(std::isnan(t_test(a, b).p));
    EXPECT_TRUE(std::isnan(welch_test(a, b).p));
    EXPECT_TRUE(std::isnan(hedges_g(a, b, 0.05).value));
    EXPECT_TRUE(std::isnan(hedges_g(a, b, 0.05).high));
  }
  EXPECT_TRUE(std::isnan(mann_whitney_test(none, same).p));
  EXPECT_TRUE(std::isnan(mann_whitney_test(same, same).p));
  EXPECT_TRUE(std::isnan(detectable_difference(1, 1, 0.05, 0.8)));
  EXPECT_TRUE(std::isnan(mean_interval(one, 0.05).low));
  EXPECT_TRUE(std::isnan(published_mean_test(one, 3.0, 12).p));
  EXPECT_TRUE(holm({}).empty());
}

TEST(Compare, AnEffectFarBeyondTheScatterHasNoInterval) { // one rounding apart: t is about 1e16
  const std::vector<double> a{1.0, 1.0 + 2.3e-16, 1.0};
  const std::vector<double> b{2.0, 2.0, 2.0};
  const Interval g = hedges_g(a, b, 0.05);
  EXPECT_GT(std::abs(g.value), 1e12);
  EXPECT_TRUE(std::isnan(g.low));
  EXPECT_TRUE(std::isnan(g.high));
}

TEST(Compare, EffectSize) {
  // d = t sqrt(1/10 + 1/10) = 0.832181; J(18) = 1 - 3/(4 18 - 1) to three digits (Hedges 1981)
  const Interval g = hedges_g(sleep_1, sleep_2, 0.05);
  EXPECT_NEAR(g.value, 0.832181 * (1.0 - 3.0 / 71.0), 5e-4);
  EXPECT_LT(g.low, 0.0); // p is 0.079
  EXPECT_GT(g.high, g.value);
}

TEST(Compare, TheIntervalOfTheEffectSizeMeetsZeroWhereTheTestIsSignificant) {
  const double p = t_test(sleep_1, sleep_2).p;
  EXPECT_NEAR(hedges_g(sleep_1, sleep_2, p).low, 0.0, 1e-8);
}

TEST(Compare, PowerAsInR) {
  EXPECT_NEAR(power(20, 20, 1.0, 0.05), 0.8689528, 1e-6);        // R: power.t.test(n = 20, delta = 1)
  EXPECT_NEAR(power(22.02110, 22.02110, 1.0, 0.05), 0.90, 1e-6); // R: power.t.test(power = .90, delta = 1)
  EXPECT_NEAR(detectable_difference(20, 20, 0.05, 0.8689528), 1.0, 1e-6);
  EXPECT_NEAR(power(12, 12, detectable_difference(12, 12, 0.05, 0.8), 0.05), 0.8, 1e-9);
  EXPECT_NEAR(power(12, 12, 0.0, 0.05), 0.05, 1e-9) << "without a difference, the level of the test";
}

TEST(Compare, HolmsCorrection) { // Wikipedia, "Holm-Bonferroni method": 0.01, 0.04, 0.03, 0.005 at 0.05
  const std::vector<double> adjusted = holm(std::vector{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(adjusted[i], expected[i], 1e-12);
  const std::vector<double> with_gap = holm(std::vector{0.04, std::numeric_limits<double>::quiet_NaN(), 0.9});
  EXPECT_NEAR(with_gap[0], 0.08, 1e-12);
  EXPECT_TRUE(std::isnan(with_gap[1]));
  EXPECT_NEAR(with_gap[2], 0.9, 1e-12);
}

TEST(Compare, APublishedMean) {
  EXPECT_NEAR(published_mean_test(sleep_1, 0.75, 10).p, 1.0, 1e-12);
  EXPECT_LT(published_mean_test(sleep_1, 20.0, 10).p, 1e-6);
  // With endless published values it is the one-sample test; R: t.test(sleep$extra[1:10], mu = 0), p = 0.2176
  EXPECT_NEAR(published_mean_test(sleep_1, 0.0, 1e12).p, 0.2176, 5e-5);
}

} // namespace
} // namespace matrigrate::statistics
