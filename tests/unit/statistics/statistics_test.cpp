#include "statistics/compare.hpp"
#include "statistics/correlation.hpp"
#include "statistics/distributions.hpp"
#include "statistics/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace matrigrate::statistics {
namespace {

/// Hours of sleep gained with two drugs (Student 1908), the data set `sleep` of R.
const std::vector<double> sleep_1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> sleep_2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

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

TEST(Sample, MomentsOfStudentsData) {
  const Moments m = moments(sleep_2);
  EXPECT_EQ(m.n, 10U);
  EXPECT_NEAR(m.mean, 2.33, 1e-12);
  EXPECT_NEAR(m.sd, 2.002249, 1e-6); // R: sd(sleep$extra[11:20])
}

TEST(Sample, AMeanOfDefinedValuesLeavesTheOthersOut) {
  EXPECT_EQ(mean_of_defined(std::vector<double>{1.0, std::nan(""), 4.0}), 2.5);
  EXPECT_TRUE(std::isnan(mean_of_defined(std::vector<double>{std::nan("")})));
}

TEST(Sample, WhatIsNotDefinedIsNaN) {
  EXPECT_TRUE(std::isnan(moments({}).mean));
  EXPECT_TRUE(std::isnan(moments(std::vector{1.0}).sd));
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
  EXPECT_TRUE(std::isnan(box({}).low_whisker));
  EXPECT_EQ(finite(std::vector{1.0, nan, 2.0}), (std::vector{1.0, 2.0}));
}

TEST(Sample, QuartilesAsInR) {
  const std::vector<double> ten{10, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_DOUBLE_EQ(quantile(ten, 0.25), 3.25); // R: quantile(1:10)
  EXPECT_DOUBLE_EQ(quantile(ten, 0.5), 5.5);
  EXPECT_DOUBLE_EQ(quantile(ten, 0.75), 7.75);
  EXPECT_DOUBLE_EQ(quantile(ten, 1.0), 10.0);
}

TEST(Sample, WhiskersEndAtTheBoxWhereTheInnermostValueLiesWithinIt) { // as matplotlib has it
  const Box b = box(std::vector<double>{0, 20.2, 20.4, 20.8});
  EXPECT_EQ(b.outliers, std::vector<double>{0.0});
  EXPECT_DOUBLE_EQ(b.low_quartile, 15.15);
  EXPECT_DOUBLE_EQ(b.low_whisker, b.low_quartile);
  EXPECT_DOUBLE_EQ(b.high_whisker, 20.8);
}

TEST(Sample, ABoxHasWhiskersAndOutliers) {
  const Box b = box(std::vector<double>{1, 2, 3, 4, 5, 30});
  EXPECT_DOUBLE_EQ(b.median, 3.5);
  EXPECT_DOUBLE_EQ(b.low_whisker, 1.0);
  EXPECT_DOUBLE_EQ(b.high_whisker, 5.0);
  EXPECT_EQ(b.outliers, std::vector<double>{30.0});
}

} // namespace
} // namespace matrigrate::statistics
