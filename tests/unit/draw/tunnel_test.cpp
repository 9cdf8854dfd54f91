#include "draw/tunnel.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace matrigrate::draw {
namespace {

observe::CellScene empty() {
  observe::CellScene s;
  s.radius = 60.0;
  s.spacing = 2.0;
  return s;
}

/// A disc of 60 um with fluid within a radius. @param stretch  of the fluid, as where it drifts apart
observe::CellScene scene(double radius, double stretch = 1.0) {
  observe::CellScene s = empty();
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) {
      const Vec2 x(2.0 * i, 2.0 * j);
      if (x.norm() > 60.0) continue;
      const Vec2 apart(stretch * x.x(), x.y());
      if (x.norm() <= radius) {
        if (apart.norm() <= radius) s.matrix.back().push_back(apart);
      } else {
        s.matrix.front().push_back(x);
      }
    }
  return s;
}

double area_of(const std::vector<Curve>& edges) {
  double sum = 0.0;
  for (const Curve& edge : edges) sum += enclosed(edge);
  return sum;
}

TEST(DegradedEdges, EncloseTheDegradedParticles) {
  const auto s = scene(20.0);
  const auto edges = degraded_edges(s, whole_disc(s));
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_NEAR(area_of(edges), 4.0 * static_cast<double>(s.matrix.back().size()), 0.04 * 400.0 * std::numbers::pi);
}

TEST(DegradedEdges, HaveNoSpecksWhereFluidDriftsApart) {
  const auto s = scene(20.0, 1.6);
  EXPECT_EQ(degraded_edges(s, whole_disc(s)).size(), 1U);
}

TEST(DegradedEdges, KeepAnIslandOfIntactMatrix) {
  auto s = scene(30.0);
  std::erase_if(s.matrix.back(), [](const Vec2& x) { return x.norm() < 10.0; });
  EXPECT_EQ(degraded_edges(s, whole_disc(s)).size(), 2U);
}

TEST(DegradedEdges, CountWhatIsHalfDegradedAsTheEdge) {
  auto s = scene(0.0);
  s.matrix[1] = scene(20.0).matrix.back(); // a sixth degraded
  EXPECT_TRUE(degraded_edges(s, whole_disc(s)).empty());
  s.matrix[3].swap(s.matrix[1]); // five sixths
  EXPECT_EQ(degraded_edges(s, whole_disc(s)).size(), 1U);
}

TEST(DegradedEdges, AreNoneOfIntactMatrixOrElsewhere) {
  observe::CellScene s = empty();
  EXPECT_TRUE(degraded_edges(s, whole_disc(s)).empty());
  s = scene(10.0);
  EXPECT_TRUE(degraded_edges(s, {Vec2(30, 30), Vec2(50, 50)}).empty());
}

} // namespace
} // namespace matrigrate::draw
