#include "cell/geometry.hpp"

#include "ring.hpp"

using namespace matrigrate;

namespace {

/// An L of area 3, counter-clockwise.
CortexState letter_l() { return polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}); }

CellParameters off_centre() {
  CellParameters p;
  p.start_x = 40.0;
  p.start_y = -7.0;
  return p;
}

CortexState reversed(CortexState c) {
  std::reverse(c.x.begin(), c.x.end());
  return c;
}

} // namespace

TEST(Geometry, AreaCentroidAndPerimeterOfAnL) {
  const CortexState c = letter_l();
  EXPECT_NEAR(area(c), 3.0, 1e-15);
  EXPECT_NEAR(perimeter(c), 8.0, 1e-15);
  EXPECT_LT((centroid(c) - Vec2(2.5 / 3.0, 2.5 / 3.0)).norm(), 1e-15);
  EXPECT_NEAR(area(reversed(c)), -3.0, 1e-15);
}

TEST(Geometry, MovesWithTheRing) {
  const Motion motion{.shift = Vec2(1e4, -2e4)};
  const CortexState c = wavy_cortex(CellParameters{});
  const CortexState there = moved(c, motion);
  EXPECT_NEAR(area(there), area(c), 1e-8);
  EXPECT_NEAR(perimeter(there), perimeter(c), 1e-8);
  EXPECT_LT((centroid(there) - motion(centroid(c))).norm(), 1e-8);
  for (std::size_t i = 0; i < c.size(); ++i) {
    EXPECT_LT((normal(there, i) - motion.R * normal(c, i)).norm(), 1e-9);
    EXPECT_NEAR(curvature(there, i), curvature(c, i), 1e-9);
  }
}

TEST(Geometry, OfTheRoundCell) {
  const CellParameters p = off_centre();
  const CortexState c = round_cortex(p);
  const Vec2 centre(p.start_x, p.start_y);
  EXPECT_NEAR(area(c), initial_area(p), 1e-9);
  EXPECT_NEAR(area(c), std::numbers::pi * 225.0, 0.1);
  EXPECT_NEAR(perimeter(c), 235.0 * initial_segment_length(p), 1e-10);
  EXPECT_LT((centroid(c) - centre).norm(), 1e-10);
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_LT((normal(c, i) - (c.x[i] - centre) / 15.0).norm(), 1e-12);
}

TEST(Geometry, CentroidDoesNotDependOnTheSpacingOfParticles) {
  CortexState c = box(4.0, 4.0, 1.0);
  const CortexState coarse = polygon({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  c.x.insert(c.x.begin() + 1, {{-1.9, -2.0}, {-1.8, -2.0}, {-1.7, -2.0}});
  EXPECT_LT((centroid(c) - centroid(coarse)).norm(), 1e-15);
}

TEST(Geometry, TheCentreOfMassIsThatOfTheParticles) {
  const CortexState c = letter_l();
  EXPECT_LT((centre_of_mass(c) - Vec2(1.0, 1.0)).norm(), 1e-15);
  EXPECT_GT((centre_of_mass(c) - centroid(c)).norm(), 0.1);
}

TEST(Geometry, AreaGradientIsTheDerivative) {
  CortexState c = wavy_cortex(small_cell());
  std::vector<Vec2> minus_gradient;
  for (std::size_t i = 0; i < c.size(); ++i) minus_gradient.push_back(-area_gradient(c, i));
  EXPECT_LT(net_force(minus_gradient).norm(), 1e-13);
  expect_minus_gradient(minus_gradient, c.x, [&] { return area(c); });
}

TEST(Curvature, OfACircleIsOneOverItsRadius) {
  const CortexState c = round_cortex(off_centre());
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(curvature(c, i), 1.0 / 15.0, 1e-12);
  const CortexState inside_out = reversed(c);
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(curvature(inside_out, i), -1.0 / 15.0, 1e-12);
}

TEST(Curvature, DoesNotDependOnTheSpacingOnACircle) {
  CortexState c = round_cortex(CellParameters{});
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / 235.0 + 0.02 * std::sin(static_cast<double>(i));
    c.x[i] = 15.0 * Vec2(std::cos(a), std::sin(a));
  }
  for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(curvature(c, i), 1.0 / 15.0, 1e-12);
}

TEST(Curvature, VanishesOnAStraightSideAndIsNegativeInANotch) {
  CortexState c = box(20.0, 20.0, 1.0);
  EXPECT_NEAR(curvature(c, 10), 0.0, 1e-15);
  EXPECT_GT(curvature(c, 20), 0.0); // at the corner
  c.x[10].y() += 1.0;               // inwards
  EXPECT_LT(curvature(c, 10), 0.0);
  c.x[13] = c.x[7] = c.x[10]; // all in one point
  EXPECT_EQ(curvature(c, 10), 0.0);
}

TEST(ClosestPoint, InTheMiddleAtTheEndsAndOnAPoint) {
  const Vec2 a(1, 1);
  const Vec2 b(5, 1);
  const ClosestPoint middle = closest_point({2, 4}, a, b);
  EXPECT_DOUBLE_EQ(middle.s, 0.25);
  EXPECT_EQ(middle.from, Vec2(0, 3));
  const ClosestPoint before = closest_point({-2, 5}, a, b);
  EXPECT_EQ(before.s, 0.0);
  EXPECT_EQ(before.from, Vec2(-3, 4));
  const ClosestPoint behind = closest_point({8, -3}, a, b);
  EXPECT_EQ(behind.s, 1.0);
  EXPECT_EQ(behind.from, Vec2(3, -4));
  EXPECT_EQ(closest_point({3, 1}, a, b).from.norm(), 0.0);
  EXPECT_EQ(closest_point({4, 5}, a, a).from, Vec2(3, 4)); // a segment without length
}

TEST(CrossesItself, OnlyWhereSegmentsThatAreNoNeighboursMeet) {
  EXPECT_FALSE(crosses_itself(letter_l()));
  EXPECT_FALSE(crosses_itself(wavy_cortex(CellParameters{})));
  EXPECT_TRUE(crosses_itself(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}))); // a bow tie
  CortexState c = round_cortex(CellParameters{});
  c.x[100] = Vec2(20.0, 0.3); // a spike through the opposite side
  EXPECT_TRUE(crosses_itself(c));
  c.x[100] = Vec2(14.0, 0.3); // almost
  EXPECT_FALSE(crosses_itself(c));
  std::rotate(c.x.begin(), c.x.begin() + 100, c.x.end()); // the spike where the ring closes
  EXPECT_FALSE(crosses_itself(c));
  c.x[0] = Vec2(20.0, 0.3);
  EXPECT_TRUE(crosses_itself(c));
}

TEST(Contains, InsideOfAnLNotItsNotch) {
  const CortexState c = letter_l();
  for (const Vec2& p : {Vec2(0.5, 0.5), Vec2(1.5, 0.5), Vec2(0.5, 1.5), Vec2(0.5, 1.0)}) EXPECT_TRUE(contains(c, p));
  for (const Vec2& p : {Vec2(1.5, 1.5), Vec2(-0.1, 0.5), Vec2(0.5, 2.1), Vec2(3.0, 1.0), Vec2(-1.0, 0.0)})
    EXPECT_FALSE(contains(c, p));
  EXPECT_TRUE(contains(reversed(c), {0.5, 1.5}));
}

TEST(Contains, AgreesWithTheRadiusOfARoundCell) {
  const CortexState c = round_cortex(CellParameters{});
  for (double y = -18.0; y < 18.5; y += 0.75)
    for (double x = -18.0; x < 18.5; x += 0.75) {
      const double r = std::hypot(x, y);
      if (std::abs(r - 15.0) > 0.01) {
        EXPECT_EQ(contains(c, {x, y}), r < 15.0) << x << ", " << y;
      }
    }
}

TEST(Front, IsTheHalfThatLiesFurthestAlong) {
  for (const double angle : {0.0, 1.0, 3.0, -2.2}) {
    const CortexState c = wavy_cortex(CellParameters{});
    const Vec2 d(std::cos(angle), std::sin(angle));
    const std::vector<std::uint8_t> is_front = front(c, angle);
    double last_of_front = 1e9;
    double first_of_rear = -1e9;
    for (std::size_t i = 0; i < c.size(); ++i) {
      double& limit = is_front[i] ? last_of_front : first_of_rear;
      limit = is_front[i] ? std::min(limit, c.x[i].dot(d)) : std::max(limit, c.x[i].dot(d));
    }
    EXPECT_EQ(std::count(is_front.begin(), is_front.end(), 1), 117);
    EXPECT_GE(last_of_front, first_of_rear);
  }
}
