#include "solve/coarse_levels.hpp"
#include "solve/conjugate_gradient.hpp"
#include "solve/elimination.hpp"
#include "solve/lumped_links.hpp"
#include "solve/row_blocks.hpp"
#include "synthetic.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace matrigrate;

namespace {

/// A ring of nodes with unequal couplings; node 0 has a prescribed velocity.
struct Ring {
  explicit Ring(std::size_t n) {
    pairs.first.push_back(0);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      for (const std::size_t j : {std::min(before, after), std::max(before, after)}) {
        const bool prescribed = i == 0 || j == 0;
        const double G = 1.0 + static_cast<double>(std::min(i, j) % 5);
        pairs.index.push_back(static_cast<std::uint32_t>(j));
        coupling.push_back(prescribed ? 0.0 : G);
        if (i > 0) diagonal_of(i) += G;
      }
      pairs.first.push_back(static_cast<std::uint32_t>(pairs.index.size()));
    }
    diagonal_of(0) = 1.0;
    A.pairs.assign(pairs, coupling);
    A.prescribed.assign(n, 0);
    A.prescribed[0] = 1;
    for (std::size_t i = 0; i < n; ++i)
      A.F.emplace_back(std::sin(1.0 + static_cast<double>(i)), std::cos(3.0 * static_cast<double>(i)));
  }
  double& diagonal_of(std::size_t i) {
    if (A.diagonal.size() <= i) A.diagonal.resize(i + 1, 0.0);
    return A.diagonal[i];
  }
  Eigen::MatrixXd dense() const {
    const auto n = static_cast<Eigen::Index>(A.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t i = 0; i < A.size(); ++i) {
      M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = A.diagonal[i];
      for (std::uint32_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k)
        M(static_cast<Eigen::Index>(i), pairs.index[k]) -= coupling[k];
    }
    return M;
  }
  Adjacency pairs;
  std::vector<double> coupling; // beside pairs.index
  DragSystem A;
};

} // namespace

TEST(ConjugateGradient, GivesTheSolutionOfADirectSolver) {
  const Ring ring(60);
  std::vector<Vec2> v(60, Vec2::Zero());
  const SolveReport report = ConjugateGradient(1e-12, 500).solve(ring.A, v);
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.residual, 1e-12);
  Eigen::MatrixXd F(60, 2);
  for (int i = 0; i < 60; ++i) F.row(i) = ring.A.F[static_cast<std::size_t>(i)].transpose();
  const Eigen::MatrixXd exact = ring.dense().ldlt().solve(F);
  for (int i = 0; i < 60; ++i)
    EXPECT_NEAR((v[static_cast<std::size_t>(i)] - exact.row(i).transpose()).norm(), 0.0, 1e-10);
}

TEST(ConjugateGradient, TakesNoIterationFromTheSolution) {
  const Ring ring(40);
  std::vector<Vec2> v(40, Vec2::Zero());
  ConjugateGradient solver(1e-10, 500);
  EXPECT_GT(solver.solve(ring.A, v).iterations, 5);
  EXPECT_LE(solver.solve(ring.A, v).iterations, 1);
}

TEST(ConjugateGradient, SolvesForOneComponentAlone) {
  Ring ring(40);
  for (Vec2& F : ring.A.F) F.y() = 0.0;
  std::vector<Vec2> v(40, Vec2::Zero());
  EXPECT_TRUE(ConjugateGradient(1e-10, 500).solve(ring.A, v).converged);
  for (const Vec2& a : v) EXPECT_EQ(a.y(), 0.0);
}

TEST(ConjugateGradient, WithoutForcesNothingMoves) {
  Ring ring(20);
  for (Vec2& F : ring.A.F) F.setZero();
  std::vector<Vec2> v(20, Vec2(3.0, -1.0));
  EXPECT_TRUE(ConjugateGradient(1e-6, 10).solve(ring.A, v).converged);
  for (const Vec2& a : v) EXPECT_EQ(a, Vec2(0.0, 0.0));
}

TEST(ConjugateGradient, SaysWhenItGivesUp) {
  const Ring ring(60);
  std::vector<Vec2> v(60, Vec2::Zero());
  const SolveReport report = ConjugateGradient(1e-14, 3).solve(ring.A, v);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3);
}

TEST(ConjugateGradient, DoesNotTakeNanForASolution) {
  Ring ring(20);
  ring.A.F[7].x() = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec2> v(20, Vec2::Zero());
  EXPECT_FALSE(ConjugateGradient(1e-6, 50).solve(ring.A, v).converged);
}

namespace {

struct Small {
  Small() {
    synthetic::add_cell(body, 1);
    // a link between two matrix nodes, one that lists the matrix last, and a term over very many nodes of both kinds
    const auto first = static_cast<std::uint32_t>(body.x.size());
    body.A.links.add(0.7, {{400, 1.0}, {401, -0.5}, {first + 3, -0.5}});
    body.A.links.add(0.9, {{first + 9, -1.0}, {420, 1.0}});
    for (std::uint32_t k = 0; k < 70; ++k) body.A.directed.add_entry(first + 2 * k, Vec2(0.1, 0.01 * k));
    body.A.directed.add_entry(410, Vec2(0.2, 0.1));
    body.A.directed.close(2.0);
    elimination.factorise(body.A);
  }
  /// A as a dense matrix, x and y of a node in turn.
  Eigen::MatrixXd dense() const {
    const std::size_t n = body.A.size();
    Eigen::MatrixXd A(2 * n, 2 * n);
    std::vector<Vec2> unit(n, Vec2::Zero()), column(n);
    for (std::size_t k = 0; k < 2 * n; ++k) {
      unit[k / 2][static_cast<long>(k % 2)] = 1.0;
      multiply(body.A, unit, column);
      for (std::size_t i = 0; i < n; ++i) A.block<2, 1>(static_cast<long>(2 * i), static_cast<long>(k)) = column[i];
      unit[k / 2].setZero();
    }
    return A;
  }
  synthetic::Body body = synthetic::disc(30.0);
  Elimination elimination;
};

} // namespace

TEST(Elimination, GivesTheSchurComplement) {
  Small s;
  const auto n = static_cast<long>(2 * s.body.x.size());
  const Eigen::MatrixXd A = s.dense();
  const long c = A.rows() - n;
  const Eigen::MatrixXd S =
      A.topLeftCorner(n, n) - A.topRightCorner(n, c) * A.bottomRightCorner(c, c).llt().solve(A.bottomLeftCorner(c, n));
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1.0, 1.0).array().sin();
  const Eigen::VectorXd expected = S * x;

  Field from, to;
  from.resize(s.body.x.size());
  to.resize(s.body.x.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    from.x()[i] = static_cast<float>(x[static_cast<long>(2 * i)]);
    from.y()[i] = static_cast<float>(x[static_cast<long>(2 * i + 1)]);
  }
  Field D, smoother;
  D.resize(from.size());
  smoother.resize(from.size());
  s.elimination.diagonals(s.body.A, D, smoother);
  s.elimination.multiply(from);
  s.elimination.add_product(1.0F, to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    Vec2 y = D.x()[i] * Vec2(from.x()[i], from.y()[i]) + Vec2(to.x()[i], to.y()[i]);
    s.body.A.pairs.each_of_row(i, [&](std::size_t j, float G) { y -= G * Vec2(from.x()[j], from.y()[j]); });
    EXPECT_NEAR((y - expected.segment<2>(static_cast<long>(2 * i))).norm(), 0.0, 1e-5);
  }
}

TEST(Elimination, BoundsTheDiagonalFromAbove) {
  Small s;
  const Eigen::MatrixXd A = s.dense();
  Field D, smoother;
  D.resize(s.body.x.size());
  smoother.resize(s.body.x.size());
  s.elimination.diagonals(s.body.A, D, smoother);
  for (std::size_t i = 0; i < s.body.x.size(); ++i) {
    const auto k = static_cast<long>(2 * i);
    EXPECT_EQ(smoother.x()[i], smoother.y()[i]);
    EXPECT_LE(std::max(A(k, k), A(k + 1, k + 1)) * smoother.x()[i], 1.0 + 1e-6);
  }
}

TEST(Elimination, SolvesWithASolutionOfTheRest) {
  Small s;
  const auto n = static_cast<long>(2 * s.body.x.size());
  const Eigen::MatrixXd A = s.dense();
  const long c = A.rows() - n;
  Eigen::VectorXd F(A.rows());
  for (std::size_t i = 0; i < s.body.A.size(); ++i) F.segment<2>(static_cast<long>(2 * i)) = s.body.A.F[i];
  const Eigen::VectorXd exact = A.llt().solve(F);

  NodeVectors r;
  split(s.body.A.F, s.body.x.size(), r);
  s.elimination.reduce(r);
  const Eigen::MatrixXd S =
      A.topLeftCorner(n, n) - A.topRightCorner(n, c) * A.bottomRightCorner(c, c).llt().solve(A.bottomLeftCorner(c, n));
  const Eigen::VectorXd reduced = S * exact.head(n);
  for (std::size_t i = 0; i < s.body.x.size(); ++i)
    EXPECT_NEAR((r[i] - reduced.segment<2>(static_cast<long>(2 * i))).norm(), 0.0, 1e-9);

  Field v_m;
  v_m.resize(s.body.x.size());
  Eigen::VectorXd x(n); // v_m as it is, in double precision
  for (std::size_t i = 0; i < s.body.x.size(); ++i)
    for (long e = 0; e < 2; ++e) {
      const long k = 2 * static_cast<long>(i) + e;
      (e == 0 ? v_m.x() : v_m.y())[i] = static_cast<float>(exact[k]);
      x[k] = static_cast<float>(exact[k]);
    }
  const std::span<const Vec2> F_c = std::span<const Vec2>(s.body.A.F).subspan(s.body.x.size());
  std::vector<Vec2> v_c(F_c.size());
  s.elimination.recover(F_c, v_m, v_c);
  const Eigen::VectorXd expected = A.bottomRightCorner(c, c).llt().solve(F.tail(c) - A.bottomLeftCorner(c, n) * x);
  for (std::size_t k = 0; k < v_c.size(); ++k)
    EXPECT_NEAR((v_c[k] - expected.segment<2>(static_cast<long>(2 * k))).norm(), 0.0, 1e-9);
}

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

Grid grid_around_three_nodes() {
  const std::vector<Vec2> x{{0.1, 0.2}, {1.3, 0.4}, {0.7, 1.9}};
  Grid grid(x, 1.0);
  grid.locate(x, std::vector<std::uint8_t>(3, 1));
  return grid;
}

Field zeros(std::size_t n) {
  Field a;
  a.resize(n);
  return a;
}

void subtract_product(LumpedLinks links, const Grid& grid, const Field& x, Field& r) {
  links.multiply(grid, x);
  links.subtract_from(grid, r);
}

} // namespace

TEST(LumpedLinks, LetARigidMotionPassIfNothingHoldsTheNodesBehind) {
  const Grid grid = grid_around_three_nodes();
  Field x = zeros(grid.size()), r = x;
  std::fill_n(x.x(), grid.size(), 2.0F);
  std::fill_n(x.y(), grid.size(), -1.0F);
  subtract_product(three_nodes(0.0), grid, x, r);
  for (std::size_t q = 0; q < grid.size(); ++q) EXPECT_NEAR(std::hypot(r.x()[q], r.y()[q]), 0.0F, 1e-6F);
}

TEST(LumpedLinks, HoldTheMatrixIfTheNodesBehindAreHeld) {
  const Grid grid = grid_around_three_nodes();
  Field x = zeros(grid.size()), r = x;
  std::fill_n(x.y(), grid.size(), 2.0F);
  const LumpedLinks links = three_nodes(1e9);
  subtract_product(links, grid, x, r);
  const float sum = links.drag(0) + links.drag(1) + links.drag(2);
  EXPECT_NEAR(std::accumulate(r.y(), r.y() + grid.size(), 0.0F), -2.0F * sum, 1e-5F);
  EXPECT_EQ(std::accumulate(r.x(), r.x() + grid.size(), 0.0F), 0.0F);
}

TEST(LumpedLinks, AreTheSameOnAGridAsAMatrix) {
  const LumpedLinks links = three_nodes(0.3);
  const Grid grid = grid_around_three_nodes();
  const auto n = static_cast<long>(grid.size());
  Eigen::MatrixXf A = Eigen::MatrixXf::Zero(n, n);
  links.add_to(grid, A);
  for (long q = 0; q < n; ++q) {
    Field unit = zeros(grid.size()), column = unit;
    unit.x()[q] = 1.0F;
    subtract_product(links, grid, unit, column);
    for (long p = 0; p < n; ++p) EXPECT_NEAR(-column.x()[p], A(std::max(p, q), std::min(p, q)), 1e-6F);
  }
}

namespace {

Field some_values(std::size_t n) {
  Field a;
  a.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    a.x()[i] = std::sin(1.0F + static_cast<float>(i));
    a.y()[i] = std::cos(0.3F * static_cast<float>(i));
  }
  return a;
}

Field diagonal(const synthetic::Body& body) {
  Field D;
  D.resize(body.x.size());
  for (std::size_t i = 0; i < D.size(); ++i) D.x()[i] = static_cast<float>(body.A.diagonal[i]);
  return D;
}

} // namespace

TEST(RowBlocks, MultiplyAsTheSystemDoes) {
  for (const bool stirred : {false, true}) {
    synthetic::Body body = synthetic::disc(31.0);
    if (stirred) synthetic::stir(body, 20.0, 6.0, 0.5);
    const std::size_t n = body.x.size();
    ASSERT_NE(n % Field::lanes, 0U); // the last block is not full
    const Field x = some_values(n);
    Field y = some_values(n);
    body.A.pairs.multiply(diagonal(body), x, y);
    std::vector<Vec2> v(n), expected(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = Vec2(x.x()[i], x.y()[i]);
    for (std::size_t i = 0; i < n; ++i) {
      expected[i] = body.A.diagonal[i] * v[i];
      if (body.prescribed[i]) continue;
      for (const std::uint32_t j : body.pairs.of(i))
        if (!body.prescribed[j])
          expected[i] -= synthetic::drag((body.x[i] - body.x[j]).norm(), body.volume * body.volume) * v[j];
    }
    std::vector<Vec2> product(n);
    multiply(body.A, v, product);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR((product[i] - expected[i]).norm(), 0.0, 1e-5);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(y.x()[i], expected[i].x(), 1e-5);
      EXPECT_NEAR(y.y()[i], expected[i].y(), 1e-5);
    }
  }
}

TEST(RowBlocks, DoNotSeeHowFarTheListReaches) {
  synthetic::Body near = synthetic::disc(31.0);
  synthetic::Body far = synthetic::disc(31.0);
  near.assemble(0.1);
  far.assemble(2.0);
  ASSERT_LT(near.pairs.pairs(), far.pairs.pairs());
  const Field x = some_values(near.x.size());
  Field a = x, b = x;
  near.A.pairs.residual(diagonal(near), x, x, a);
  far.A.pairs.residual(diagonal(far), x, x, b);
  EXPECT_EQ(a.values(), b.values());
}
