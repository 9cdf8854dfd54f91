#include "ecm/law/material.hpp"
#include "simulation/march.hpp"
#include "state/initial.hpp"

#include "sph/interpolate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

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

namespace {

/// A row of docs/validation/graded-point-force.csv, which tools/graded_reference.py has from finite elements.
struct ReferencePoint {
  char force; ///< along x or y
  Vec2 X;     ///< [um]
  Vec2 u;     ///< [um]
};

std::vector<ReferencePoint> reference_points() {
  std::ifstream file(MATRIGRATE_SOURCE_DIR "/docs/validation/graded-point-force.csv");
  std::vector<ReferencePoint> points;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    ReferencePoint point{};
    char comma = 0;
    std::istringstream(line) >> point.force >> comma >> point.X.x() >> comma >> point.X.y() >> comma >> point.u.x()
        >> comma >> point.u.y();
    points.push_back(point);
  }
  return points;
}

/// A disc of a graded gel at rest under 0.06 nN at its centre.
State pulled(const Parameters& p, const Vec2& direction) {
  State s;
  s.ecm = disc(p);
  apply({.E_ratio = [](const Vec2& X) { return 1.0 + 0.6 * std::tanh(X.x() / 20.0); }}, s.ecm);
  const PointWeights centre = solid_weights(s.ecm, Kernel(p.ecm.smoothing_length), Vec2::Zero());
  Workspace w(s, p);
  march(s, p, w, 20.0 * p.ecm.viscosity / moduli(p.ecm).G,
        [&](const State&, std::span<Vec2> force) { spread(centre, 0.06 * direction, force); });
  return s;
}

} // namespace

// The place of the clamp is known to a spacing, and the load is spread over the kernel: as in `validate point-force`.
TEST(GradedDisc, GivesWayToAPointForceAsInFiniteElements) {
  Parameters p;
  p.ecm.radius = 80.0;
  p.ecm.cell_hole = false;
  const std::vector<ReferencePoint> points = reference_points();
  ASSERT_EQ(points.size(), 88U);
  for (const char along : {'x', 'y'}) {
    const State s = pulled(p, along == 'x' ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0));
    double difference = 0.0, size = 0.0, asymmetry = 0.0, expected_asymmetry = 0.0;
    for (const ReferencePoint& point : points) {
      if (point.force != along) continue;
      const auto nearest = std::ranges::min_element(s.ecm.X, {}, [&](const Vec2& X) { return (X - point.X).norm(); });
      ASSERT_LT((*nearest - point.X).norm(), 1e-9);
      const Vec2 u = s.ecm.displacement(static_cast<std::size_t>(nearest - s.ecm.X.begin()));
      difference += (u - point.u).squaredNorm();
      size += point.u.squaredNorm();
      const double side = point.X.x() > 0.0 ? 1.0 : point.X.x() < 0.0 ? -1.0 : 0.0; // stiff or soft
      asymmetry += side * u.norm();
      expected_asymmetry += side * point.u.norm();
    }
    EXPECT_LT(std::sqrt(difference / size), 0.05) << "force along " << along;
    EXPECT_NEAR(asymmetry / expected_asymmetry, 1.0, 0.05) << "the soft side moves further";
  }
}
