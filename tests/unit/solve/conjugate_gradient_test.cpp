#include "solve/conjugate_gradient.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <limits>

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
