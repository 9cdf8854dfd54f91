#include "draw/axis.hpp"

#include <gtest/gtest.h>

namespace matrigrate::draw {
namespace {

TEST(Axis, PutsItsEndsAtItsPixels) {
  const Axis axis{.low = 10.0, .high = 1000.0, .begin = 100.0, .end = 0.0, .ticks = {}};
  EXPECT_DOUBLE_EQ(axis.at(10.0), 100.0);
  EXPECT_DOUBLE_EQ(axis.at(505.0), 50.0);
  EXPECT_DOUBLE_EQ(axis.at(1000.0), 0.0);
}

TEST(Axis, ReachesFromTheSmallestToTheLargestValue) {
  const Axis axis = fitted_axis(std::vector<double>{3.0, -1.0, 2.0});
  EXPECT_EQ(axis.low, -1.0);
  EXPECT_EQ(axis.high, 3.0);
}

TEST(Axis, GivesOneValueANeighbourhood) {
  for (const double value : {0.0, 5.0, -1e-9, 1e140}) {
    const Axis axis = fitted_axis(std::vector<double>{value});
    EXPECT_LT(axis.low, value);
    EXPECT_GT(axis.high, value);
  }
}

} // namespace
} // namespace matrigrate::draw
