#include "solve/interpolation.hpp"

#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

namespace {

/// A lattice of 23 x 11 nodes, some of them held or far off, and a grid of twice its spacing.
struct Nodes {
  Nodes() {
    for (int row = 0; row < 11; ++row)
      for (int column = 0; column < 23; ++column) x.emplace_back(2.0 * column, 2.0 * row);
    x[30] += Vec2(13.1, 4.4);
    free.assign(x.size(), 1);
    for (const std::size_t held : {0, 1, 47, 252}) free[held] = 0;
    grid = Grid(x, 4.0);
    grid.locate(x, free);
  }
  std::vector<Vec2> x;
  std::vector<std::uint8_t> free;
  Grid grid;
};

/// Numbers without a pattern.
Field field(std::size_t n) {
  Field a;
  a.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    a.x()[i] = std::sin(1.7F * static_cast<float>(i));
    a.y()[i] = std::cos(2.3F * static_cast<float>(i));
  }
  return a;
}

Eigen::MatrixX2d numbers(const Field& a) {
  Eigen::MatrixX2d m(static_cast<long>(a.size()), 2);
  for (std::size_t i = 0; i < a.size(); ++i)
    m.row(static_cast<long>(i)) << static_cast<double>(a.x()[i]), static_cast<double>(a.y()[i]);
  return m;
}

} // namespace

TEST(Interpolation, AddsWhatTheMatrixOfTheGridMakesOfPoints) {
  const Nodes nodes;
  const Interpolation P(nodes.grid, nodes.x.size());
  const Field a = field(nodes.grid.size());
  Field z = field(nodes.x.size());
  const Eigen::MatrixX2d expected = numbers(z) + nodes.grid.P() * numbers(a);
  P.interpolate(a, z);
  EXPECT_LT((numbers(z) - expected).cwiseAbs().maxCoeff(), 3e-6);
}

TEST(Interpolation, RestrictsWithTheTranspose) {
  const Nodes nodes;
  const Interpolation P(nodes.grid, nodes.x.size());
  const Field r = field(nodes.x.size());
  Field a = field(nodes.grid.size()); // what it was does not matter
  P.restrict_to(r, a);
  const Eigen::MatrixX2d expected = Eigen::SparseMatrix<double>(nodes.grid.P().transpose()) * numbers(r);
  EXPECT_LT((numbers(a) - expected).cwiseAbs().maxCoeff(), 3e-6);
}

TEST(Interpolation, LeavesHeldNodesAlone) {
  const Nodes nodes;
  const Interpolation P(nodes.grid, nodes.x.size());
  Field z;
  z.resize(nodes.x.size());
  P.interpolate(field(nodes.grid.size()), z);
  for (std::size_t i = 0; i < z.size(); ++i) EXPECT_EQ(nodes.free[i] == 0, z.x()[i] == 0.0F && z.y()[i] == 0.0F) << i;
}
