#include "draw/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace matrigrate::draw {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> out;
  for (const Tick& tick : ticks) out.push_back(tick.label);
  return out;
}

using Labels = std::vector<std::string>;

TEST(Ticks, StepsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(round_step(0.7), 1.0);
  EXPECT_DOUBLE_EQ(round_step(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_step(1.1), 2.0);
  EXPECT_DOUBLE_EQ(round_step(3.0), 5.0);
  EXPECT_DOUBLE_EQ(round_step(5.1), 10.0);
  EXPECT_DOUBLE_EQ(round_step(0.03), 0.05);
  EXPECT_DOUBLE_EQ(round_step(1e-7), 1e-7);
}

TEST(Ticks, LinearTicksCarryEqualDigits) {
  EXPECT_EQ(labels(linear_ticks(0.0, 1.0, 5)), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(linear_ticks(-12.0, 31.0, 5)), (Labels{"\u221210", "0", "10", "20", "30"}));
  EXPECT_EQ(labels(linear_ticks(-0.3, 0.3, 3)), (Labels{"\u22120.2", "0.0", "0.2"})) << "no negative zero";
  EXPECT_EQ(labels(linear_ticks(999.99, 1000.01, 2)), (Labels{"999.99", "1000.00", "1000.01"}));
}

TEST(Ticks, VeryLargeAndVerySmallNumbersTakeAPowerOfTen) {
  EXPECT_EQ(labels(linear_ticks(0.0, 4e-7, 4)), (Labels{"0", "1e\u22127", "2e\u22127", "3e\u22127", "4e\u22127"}));
  EXPECT_EQ(labels(linear_ticks(0.0, 2e6, 4)), (Labels{"0", "0.5e6", "1.0e6", "1.5e6", "2.0e6"}));
}

TEST(Ticks, LinearTicksStayInsideAndFewForAnyRange) {
  for (const double scale : {1e-140, 1e-9, 1.0, 3.7, 1e9, 1e140})
    for (const double low : {-1.0, -0.31, 0.0, 0.77})
      for (const double span : {0.0123, 1.0, 7.3}) {
        const double high = low + span;
        const auto ticks = linear_ticks(scale * low, scale * high, 6);
        ASSERT_GE(ticks.size(), 2U) << scale << ' ' << low << ' ' << span;
        ASSERT_LE(ticks.size(), 7U) << scale << ' ' << low << ' ' << span;
        EXPECT_GE(ticks.front().value, scale * (low - 1e-8 * span));
        EXPECT_LE(ticks.back().value, scale * (high + 1e-8 * span));
        for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_LT(ticks[i - 1].value, ticks[i].value);
      }
}

} // namespace
} // namespace matrigrate::draw
