#include "ecm/law/material.hpp"
#include "simulation/march.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

namespace {

constexpr double height = 60.0; // of the layer [um]

/// E over that of the parameters: 1 at the lower wall, 4 at the upper one.
double ratio(double y) { return 2.5 + 3.0 * y / height; }

/// A layer, periodic along x, whose upper wall has been moved by 0.03 um along a direction and is held.
State driven(const Parameters& p, const MatrixFields& fields, const Vec2& direction) {
  State s;
  s.ecm = strip(p.ecm, 24.0, height);
  apply(fields, s.ecm);
  const double steps = 100.0;
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (s.ecm.clamped[i] && s.ecm.X[i].y() > 0.0) s.ecm.v[i] = 0.03 / (steps * p.run.time_step) * direction;
  Workspace w(s, p);
  march(s, p, w, steps * p.run.time_step);
  for (std::size_t i = 0; i < s.ecm.size(); ++i)
    if (s.ecm.clamped[i]) s.ecm.v[i].setZero();
  march(s, p, w, s.t + 20.0 * p.ecm.viscosity / moduli(p.ecm).G);
  return s;
}

} // namespace

// In series all parts of the layer bear the same stress: the strain goes as 1/E, the displacement as ln E.
TEST(GradedLayer, IsShearedInSeries) {
  const Parameters p;
  const State s = driven(p, {.E_ratio = [](const Vec2& X) { return ratio(X.y()); }}, Vec2::UnitX());
  double low = 0.0, high = 0.0; // where u is compared, and u there: free particles furthest apart, off the walls
  double u_low = 0.0, u_high = 0.0;
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const double y = s.ecm.X[i].y();
    if (std::abs(y) > 0.5 * height - 6.0) continue;
    const double u = s.ecm.displacement(i).x();
    if (y < low) low = y, u_low = u;
    if (y > high) high = y, u_high = u;
  }
  ASSERT_GT(high - low, 40.0);
  double most = 0.0;
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const double y = s.ecm.X[i].y();
    if (y <= low || y >= high) continue;
    const double expected = std::log(ratio(y) / ratio(low)) / std::log(ratio(high) / ratio(low));
    most = std::max(most, std::abs((s.ecm.displacement(i).x() - u_low) / (u_high - u_low) - expected));
  }
  EXPECT_LT(most, 0.001) << "of the displacement between both; a uniform layer would be off by 0.12";
}

TEST(GradedLayer, OfAConstantFieldMovesLikeAUniformOne) {
  const Parameters p;
  const State uniform = driven(p, {}, Vec2::UnitX());
  const State graded = driven(p, {.E_ratio = [](const Vec2&) { return 1.0; }}, Vec2::UnitX());
  double most = 0.0;
  for (std::size_t i = 0; i < uniform.ecm.size(); ++i)
    most = std::max(most, (uniform.ecm.x[i] - graded.ecm.x[i]).norm());
  EXPECT_LT(most, 1e-6); // the systems of a step are solved to a tolerance
}

TEST(GradedLayer, HasTheStepLimitOfItsStiffestPart) {
  const Parameters p;
  State s;
  s.ecm = strip(p.ecm, 24.0, height);
  const double uniform = Workspace(s, p).limits.elastic_s;
  apply({.E_ratio = [](const Vec2& X) { return X.y() > 20.0 ? 4.0 : 0.5; }}, s.ecm);
  EXPECT_NEAR(Workspace(s, p).limits.elastic_s, 0.25 * uniform, 1e-9);
}
