#include "solve/multigrid.hpp"

#include "base/parallel.hpp"
#include "solve/conjugate_gradient.hpp"
#include "synthetic.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace matrigrate;
using namespace matrigrate::synthetic;

namespace {

constexpr double radius = 60.0;

struct Case {
  std::string name;
  bool hexagonal, stirred;
  int protrusions; // -1: no cell
  int iterations;  // a loose bound, from zero to 1e-6
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// A body that may be moved and copied together with its system.
Body body(const Case& c) {
  Body b = disc(radius, c.hexagonal);
  if (c.stirred) stir(b, 20.0, 6.0, 0.5);
  if (c.protrusions >= 0) add_cell(b, c.protrusions);
  return b;
}

std::vector<Vec2> solution(const DragSystem& A, DragSolver& solver) {
  std::vector<Vec2> v(A.size(), Vec2::Zero());
  EXPECT_TRUE(solver.solve(A, v).converged);
  return v;
}

double largest_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

double largest(const std::vector<Vec2>& a) { return largest_difference(a, std::vector<Vec2>(a.size(), Vec2::Zero())); }

/// |F - A v| / |F|, from the definition.
double relative_residual(const DragSystem& A, const std::vector<Vec2>& v) {
  std::vector<Vec2> Av(A.size());
  multiply(A, v, Av);
  double r2 = 0.0;
  double F2 = 0.0;
  for (std::size_t i = 0; i < A.size(); ++i) {
    r2 += (A.F[i] - Av[i]).squaredNorm();
    F2 += A.F[i].squaredNorm();
  }
  return std::sqrt(r2 / F2);
}

class MultigridOn : public testing::TestWithParam<Case> {
protected:
  Body reference = disc(radius, GetParam().hexagonal);
  Body now = body(GetParam());
};

TEST_P(MultigridOn, FindsTheSolutionOfTheOracle) {
  ConjugateGradient oracle(1e-11, 5000);
  Multigrid multigrid(reference.A, 2.0, 1e-9, 200);
  const std::vector<Vec2> expected = solution(now.A, oracle);
  const std::vector<Vec2> v = solution(now.A, multigrid);
  EXPECT_LT(largest_difference(v, expected), 1e-7 * largest(expected));
  EXPECT_LE(relative_residual(now.A, v), 1e-9);
}

TEST_P(MultigridOn, TakesFewIterations) {
  std::vector<Vec2> v(now.A.size(), Vec2::Zero());
  const SolveReport report = Multigrid(reference.A, 2.0, 1e-6, 200).solve(now.A, v);
  EXPECT_LE(report.iterations, GetParam().iterations);
  EXPECT_LE(report.residual, 1e-6);
  EXPECT_NEAR(report.residual, relative_residual(now.A, v), 1e-10);
}

TEST_P(MultigridOn, KnowsItsResidualWhereItIsNotComputedAnew) {
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 2e-4}) { // reductions that are believed
    std::vector<Vec2> v(now.A.size(), Vec2::Zero());
    const SolveReport report = Multigrid(reference.A, 2.0, tolerance, 200).solve(now.A, v);
    const double residual = relative_residual(now.A, v);
    EXPECT_LE(residual, tolerance);
    EXPECT_NEAR(report.residual, residual, 0.02 * residual) << tolerance;
  }
}

TEST_P(MultigridOn, HasTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<Vec2>> v;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Multigrid multigrid(reference.A, 2.0, 1e-6, 200);
    v.push_back(solution(now.A, multigrid));
  }
  EXPECT_EQ(v[0], v[1]);
  EXPECT_EQ(v[0], v[2]);
}

TEST_P(MultigridOn, KeepsNothingFromEarlierSolves) {
  Multigrid used(reference.A, 2.0, 1e-6, 200);
  Multigrid fresh(reference.A, 2.0, 1e-6, 200);
  Case other = GetParam();
  other.stirred = !other.stirred;
  other.protrusions = other.protrusions < 0 ? 1 : other.protrusions - 1;
  solution(body(other).A, used);
  EXPECT_EQ(solution(now.A, used), solution(now.A, fresh));
}

TEST_P(MultigridOn, TakesNoIterationFromTheSolution) {
  Multigrid exact(reference.A, 2.0, 1e-9, 200);
  std::vector<Vec2> v = solution(now.A, exact);
  const std::vector<Vec2> before = v;
  const SolveReport report = Multigrid(reference.A, 2.0, 1e-6, 200).solve(now.A, v);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(v, before);
}

TEST_P(MultigridOn, TakesForcesThatAreFoundBesideItsPreparation) {
  Multigrid known(reference.A, 2.0, 1e-6, 200);
  Multigrid found(reference.A, 2.0, 1e-6, 200);
  DragSystem A = now.A;
  std::ranges::fill(A.F, Vec2::Zero());
  std::vector<Vec2> v(A.size(), Vec2::Zero());
  const auto find_F = [&] { A.F = now.A.F; };
  EXPECT_TRUE(found.solve(A, find_F, v).converged);
  EXPECT_EQ(v, solution(now.A, known));
}

// Iterations from rest to 1e-6, at most. The grids stay over the reference: a matrix stirred through 6 radians
// takes 43.
INSTANTIATE_TEST_SUITE_P(Cases, MultigridOn,
                         testing::Values(Case{"matrix", false, false, -1, 12},
                                         Case{"stirred_matrix", false, true, -1, 50}, Case{"cell", false, false, 0, 20},
                                         Case{"stirred_cell", false, true, 3, 50},
                                         Case{"hexagonal_cell", true, false, 2, 20}),
                         [](const auto& test) { return test.param.name; });

} // namespace

TEST(Multigrid, IsRightWhereItsReferenceIsWrong) {
  const Body reference = disc(40.0, true);
  Body now = disc(radius);
  add_cell(now, 1);
  ConjugateGradient oracle(1e-10, 5000);
  Multigrid multigrid(reference.A, 3.0, 1e-8, 3000);
  const std::vector<Vec2> expected = solution(now.A, oracle);
  EXPECT_LT(largest_difference(solution(now.A, multigrid), expected), 1e-6 * largest(expected));
}

TEST(Multigrid, IsRightWithoutPositions) {
  Body now = disc(40.0);
  now.A.position.clear();
  Multigrid multigrid(now.A, 2.0, 1e-8, 3000);
  EXPECT_LT(relative_residual(now.A, solution(now.A, multigrid)), 1e-8);
}

TEST(Multigrid, KeepsGivenVelocities) {
  Body now = disc(40.0);
  for (std::size_t i = 0; i < now.x.size(); ++i)
    if (now.prescribed[i]) now.A.F[i] = Vec2(0.3, -0.2);
  Multigrid multigrid(now.A, 2.0, 1e-10, 200);
  const std::vector<Vec2> v = solution(now.A, multigrid);
  for (std::size_t i = 0; i < now.x.size(); ++i) {
    if (now.prescribed[i]) {
      EXPECT_LT((v[i] - Vec2(0.3, -0.2)).norm(), 1e-8);
    }
  }
}

TEST(Multigrid, WithoutForcesNothingMoves) {
  Body now = disc(40.0);
  for (Vec2& F : now.A.F) F.setZero();
  std::vector<Vec2> v(now.A.size(), Vec2(3.0, -1.0));
  EXPECT_TRUE(Multigrid(now.A, 2.0, 1e-6, 10).solve(now.A, v).converged);
  for (const Vec2& a : v) EXPECT_EQ(a, Vec2(0.0, 0.0));
}

TEST(Multigrid, SaysWhenItGivesUp) {
  const Body now = disc(40.0);
  std::vector<Vec2> v(now.A.size(), Vec2::Zero());
  const SolveReport report = Multigrid(now.A, 2.0, 1e-10, 3).solve(now.A, v);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 3);
}

TEST(Multigrid, DoesNotTakeNanForASolution) {
  Body now = disc(40.0);
  now.A.F[700].x() = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vec2> v(now.A.size(), Vec2::Zero());
  EXPECT_FALSE(Multigrid(now.A, 2.0, 1e-6, 50).solve(now.A, v).converged);
}
