#include "solve/lumped_links.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

/// Three nodes of the matrix, linked to two nodes of the cell with own drag `own`.
LumpedLinks three_nodes(double own) {
  LumpedLinks links;
  links.clear(std::vector<double>{own, own});
  using Drags = std::vector<std::pair<std::uint32_t, double>>;
  links.add(0, Drags{{0, 1.0}});
  links.add(1, Drags{{0, 2.0}, {1, 0.5}});
  links.add(2, Drags{{1, 3.0}});
  links.close();
  return links;
}

} // namespace

TEST(LumpedLinks, LetARigidMotionPassIfNothingHoldsTheNodesBehind) {
  LumpedLinks links = three_nodes(0.0);
  Field u;
  u.resize(3);
  for (std::size_t k = 0; k < 3; ++k) u.x()[k] = u.y()[k] = 2.0F;
  links.multiply(u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(u.x()[k], 0.0F, 1e-6F);
}

TEST(LumpedLinks, HoldTheMatrixIfTheNodesBehindAreHeld) {
  LumpedLinks links = three_nodes(1e9);
  Field u;
  u.resize(3);
  for (std::size_t k = 0; k < 3; ++k) u.y()[k] = 2.0F;
  links.multiply(u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(u.y()[k], 2.0F * links.drag(k), 1e-5F);
}

TEST(LumpedLinks, AreTheSameOnAGridAsAMatrix) {
  LumpedLinks links = three_nodes(0.3);
  const std::vector<Vec2> x{{0.1, 0.2}, {1.3, 0.4}, {0.7, 1.9}};
  Grid grid(x, 1.0);
  grid.locate(x, std::vector<std::uint8_t>(3, 1));
  const auto n = static_cast<long>(grid.size());
  Eigen::MatrixXf A = Eigen::MatrixXf::Zero(n, n);
  links.add_to(grid, A);
  for (long q = 0; q < n; ++q) {
    Field unit, u, column;
    unit.resize(grid.size());
    u.resize(3);
    column.resize(grid.size());
    unit.x()[q] = 1.0F;
    grid.interpolate(unit, u);
    links.multiply(u);
    grid.restrict_to(u, column);
    for (long p = 0; p < n; ++p) EXPECT_NEAR(column.x()[p], A(p, q), 1e-6F);
  }
}
