#include "solve/elimination.hpp"

#include "synthetic.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

using namespace matrigrate;

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
  s.elimination.add_product(1.0F, from, to);
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
