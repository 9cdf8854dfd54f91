#include "base/time_text.hpp"

#include <gtest/gtest.h>

namespace matrigrate {
namespace {

TEST(TimeText, IsForPeople) {
  EXPECT_EQ(time_text(0.0), "0 s");
  EXPECT_EQ(time_text(36.0), "36 s");
  EXPECT_EQ(time_text(90.0), "1 min 30 s");
  EXPECT_EQ(time_text(1800.0), "30 min");
  EXPECT_EQ(time_text(7200.0), "2 h");
  EXPECT_EQ(time_text(9000.0000001), "2 h 30 min");
}

TEST(WallTimeText, HasOneUnit) {
  EXPECT_EQ(wall_time_text(89.0), "89 s");
  EXPECT_EQ(wall_time_text(5340.0), "89 min");
  EXPECT_EQ(wall_time_text(5400.0), "1.5 h");
}

} // namespace
} // namespace matrigrate
