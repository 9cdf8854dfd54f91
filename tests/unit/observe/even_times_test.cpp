#include "observe/even_times.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace matrigrate::observe {
namespace {

TEST(EvenTimes, AreToldFromUnevenOnes) {
  const std::vector<double> even{0, 5, 10.0000001, 15};
  EXPECT_TRUE(even_times(even).is_even());
  EXPECT_EQ(even_times(even).interval, 5.0);
  EXPECT_EQ(even_times(even).text(), "every 5 s");
  const std::vector<double> uneven{0, 7.5, 15, 21.25, 30, 35};
  EXPECT_EQ(even_times(uneven).even, 3U);
  EXPECT_FALSE(even_times(uneven).but_the_last());
  EXPECT_EQ(even_times(uneven).text(), "unevenly spaced, 5 to 8.75 s apart");
  const std::vector<double> again{0, 10, 25, 30, 40}; // later ones fit again
  EXPECT_EQ(even_times(again).even, 2U);
}

TEST(EvenTimes, MayHaveALastOneThatComesTooSoon) {
  const std::vector<double> ended{0, 70, 140, 180}, late{0, 5, 10, 17.5}, two{0, 180};
  EXPECT_FALSE(even_times(ended).is_even());
  EXPECT_TRUE(even_times(ended).but_the_last());
  EXPECT_FALSE(even_times(late).but_the_last());
  EXPECT_TRUE(even_times(two).is_even());
  EXPECT_TRUE(even_times(std::vector<double>{}).is_even());
}

TEST(EvenTimes, OfRowsAreThoseOfAllCellsTogether) {
  const std::vector<TrackRow> rows{{.t = 0.0, .polarization = {}},
                                   {.t = 0.0, .cell = 1, .polarization = {}},
                                   {.t = 60.0, .polarization = {}},
                                   {.t = 60.0, .cell = 1, .polarization = {}}};
  EXPECT_EQ(times_of(rows), (std::vector<double>{0, 60}));
}

} // namespace
} // namespace matrigrate::observe
