#include "observe/displacement_statistics.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace matrigrate;

namespace {

/// Rows every 60 s that follow a path.
template <class Path>
std::vector<TrackRow> walk(int n, const Path& path) {
  std::vector<TrackRow> rows(static_cast<std::size_t>(n) + 1);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    rows[k].t = 60.0 * static_cast<double>(k);
    rows[k].centre = path(static_cast<double>(k));
  }
  return rows;
}

} // namespace

TEST(Msd, OfAStraightPathGrowsAsTheSquareOfTheLag) {
  const auto rows = walk(360, [](double k) { return Vec2(0.3 * k, -0.4 * k); });
  const std::vector<MsdPoint> points = mean_square_displacement(rows, 600.0);
  ASSERT_EQ(points.size(), 18U); // up to half of six hours
  EXPECT_DOUBLE_EQ(points[0].lag, 600.0);
  EXPECT_NEAR(points[0].msd, 25.0, 1e-9);
  EXPECT_EQ(points[0].samples, 36U);
  EXPECT_NEAR(points[3].msd, 400.0, 1e-9);
  EXPECT_NEAR(msd_slope(points), 2.0, 1e-12);
}

TEST(Msd, OfARandomWalkGrowsInProportionToTheLag) {
  double slope = 0.0;
  constexpr int walks = 200;
  for (std::uint64_t seed = 1; seed <= walks; ++seed) {
    Vec2 x = Vec2::Zero();
    const auto rows = walk(360, [&](double k) {
      const double a = 2.0 * std::numbers::pi * uniform(seed, Purpose::test, static_cast<std::uint64_t>(k), 0);
      x += Vec2(std::cos(a), std::sin(a));
      return x;
    });
    slope += msd_slope(mean_square_displacement(rows, 60.0)) / walks;
  }
  EXPECT_NEAR(slope, 1.0, 0.1);
}

TEST(Msd, HasTheBitsOfSumsByTime) {
  const auto rows = walk(41, [](double k) { return Vec2(7.3 * std::sin(1.7 * k * k), 0.31 * k + std::cos(k)); });
  const std::vector<MsdPoint> points = mean_square_displacement(rows, 60.0);
  ASSERT_EQ(points.size(), 20U);
  for (std::size_t lag = 1; lag <= points.size(); ++lag) {
    double sum = 0.0;
    for (std::size_t k = 0; k + lag < rows.size(); ++k) sum += (rows[k + lag].centre - rows[k].centre).squaredNorm();
    EXPECT_EQ(points[lag - 1].msd, sum / static_cast<double>(rows.size() - lag)) << lag;
  }
}

TEST(Msd, NeedsRowsAtMultiplesOfTheInterval) {
  const auto rows = walk(20, [](double k) { return Vec2(k, 0.0); });
  EXPECT_TRUE(mean_square_displacement(rows, 90.0).empty());
  EXPECT_TRUE(mean_square_displacement({}, 60.0).empty());
  EXPECT_TRUE(std::isnan(msd_slope({})));
  EXPECT_EQ(mean_square_displacement(rows, 120.0).size(), 5U);
}

TEST(Guidance, AnglesAreZeroAlongAndNinetyAcrossWithoutSign) {
  const auto rows = walk(40, [](double k) { return Vec2(k, 0.0); });
  const auto angles = [&](double direction, double wanted) {
    const Guidance g = guidance(rows, direction, 60.0);
    for (const double angle : {g.path_angle, g.step_angle, g.net_angle}) EXPECT_NEAR(angle, wanted, 1e-9);
  };
  angles(0.0, 0.0);
  angles(std::numbers::pi, 0.0);
  angles(0.5 * std::numbers::pi, 90.0);
  angles(-0.25 * std::numbers::pi, 45.0);
  const auto circle = walk(400, [](double k) { return Vec2(std::cos(0.01571 * k), std::sin(0.01571 * k)); });
  EXPECT_NEAR(guidance(circle, 0.3, 60.0).path_angle, 45.0, 0.5);
  const Guidance still = guidance(walk(40, [](double) { return Vec2(1.0, 1.0); }), 0.0, 60.0);
  for (const double angle : {still.path_angle, still.step_angle, still.net_angle}) EXPECT_TRUE(std::isnan(angle));
}

TEST(Guidance, WeighsStepsByTheirLengthOrNot) {
  const auto rows = walk(4, [](double k) { return Vec2(3.0 * std::ceil(0.5 * k), std::floor(0.5 * k)); });
  const Guidance g = guidance(rows, 0.0, 60.0); // three along, one across, and again
  EXPECT_NEAR(g.path_angle, 22.5, 1e-9);
  EXPECT_NEAR(g.step_angle, 45.0, 1e-9);
  EXPECT_NEAR(g.net_angle, std::atan2(2.0, 6.0) * 180.0 / std::numbers::pi, 1e-9);
}

TEST(Guidance, ToAndFroAlongTheFibresIsNotFollowingThem) {
  // 8 um along the fibres and back in two hours, and 1 um across in an hour, for six hours
  const auto rows = walk(360, [](double k) { return Vec2(8.0 * std::abs(std::remainder(k / 60.0, 2.0)), k / 60.0); });
  const Guidance g = guidance(rows, 0.0, 600.0);
  EXPECT_LT(g.path_angle, 8.0);
  EXPECT_GT(g.ratios[0], 20.0);
  EXPECT_GT(g.ratios[1], 2.0);
  EXPECT_NEAR(g.ratios[2], 0.0, 1e-12);
  EXPECT_NEAR(g.net_angle, 90.0, 1e-9);
  EXPECT_NEAR(guidance(rows, 0.5 * std::numbers::pi, 600.0).ratios[0], 1.0 / g.ratios[0], 1e-12);
}

TEST(Guidance, HasNoRatioAtALagThatIsLongerThanThePath) {
  const auto rows = walk(200, [](double k) { return Vec2(k, 2.0 * k); });
  const Guidance g = guidance(rows, 0.0, 600.0);
  EXPECT_NEAR(g.ratios[0], 0.25, 1e-12);
  EXPECT_NEAR(g.ratios[1], 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(g.ratios[2]));
}
