#include "statistics/sample.hpp"

#include "samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace matrigrate::statistics {
namespace {

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
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(finite(std::vector{1.0, nan, 2.0}), (std::vector{1.0, 2.0}));
}

TEST(Sample, QuartilesAsInR) {
  const std::vector<double> x{10, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_DOUBLE_EQ(quantile(x, 0.25), 3.25); // R: quantile(1:10)
  EXPECT_DOUBLE_EQ(quantile(x, 0.5), 5.5);
  EXPECT_DOUBLE_EQ(quantile(x, 0.75), 7.75);
  EXPECT_DOUBLE_EQ(quantile(x, 1.0), 10.0);
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
