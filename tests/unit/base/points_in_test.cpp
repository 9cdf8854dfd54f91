#include "base/points_in.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace matrigrate;

namespace {

/// n points in the square of 100 um around the origin.
std::vector<Vec2> scattered(std::uint32_t n) {
  std::vector<Vec2> points;
  for (std::uint32_t k = 0; k < n; ++k)
    points.emplace_back(100.0 * std::sin(12.9 * k) * std::cos(0.3 * k), 100.0 * std::sin(7.7 * k + 1.0));
  return points;
}

} // namespace

TEST(PointsIn, AreThoseThatEachPointAloneWouldName) {
  for (const std::uint32_t n : {0U, 1U, 7U, 255U, 256U, 257U, 3000U}) {
    const std::vector<Vec2> points = scattered(n);
    const Box box{{-30.0, 10.0}, {25.0, 70.0}};
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < n; ++k)
      if (points[k].x() >= -30.0 && points[k].x() <= 25.0 && points[k].y() >= 10.0 && points[k].y() <= 70.0)
        expected.push_back(k);
    EXPECT_EQ(points_in(box, points), expected) << n;
  }
}

TEST(PointsIn, TakeThoseOnTheEdgeAndNoneThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 2.0}, {1.1, 1.0}, {nan, 1.0}, {0.5, nan}, {0.5, 2.0}};
  EXPECT_EQ(points_in({{0.0, 0.0}, {1.0, 2.0}}, points), (std::vector<std::uint32_t>{0, 1, 5}));
  EXPECT_EQ(points_in(unbounded_along_x({{0.0, 0.5}, {1.0, 1.5}}), points), (std::vector<std::uint32_t>{2}));
}

TEST(PointsIn, AroundAPointAreAllWithinReach) {
  const std::vector<Vec2> points = scattered(3000);
  for (const Vec2& centre : {Vec2(1e-9, 0.0), Vec2(37.1, -80.3)}) {
    const std::vector<std::uint32_t> found = points_in(around(centre, 5.2), points);
    for (std::uint32_t k = 0; k < points.size(); ++k)
      EXPECT_TRUE((points[k] - centre).norm() > 5.2 || std::ranges::binary_search(found, k));
  }
}

TEST(Marks, AreFoundOneAfterTheOther) {
  const std::vector<std::uint8_t> marks{0, 1, 0, 0, 1, 1, 0};
  EXPECT_EQ(next_marked(marks, 0), 1U);
  EXPECT_EQ(next_marked(marks, 2), 4U);
  EXPECT_EQ(next_marked(marks, 5), 5U);
  EXPECT_EQ(next_marked(marks, 6), 7U) << "none";
  EXPECT_EQ(next_marked(marks, 7), 7U);
}
