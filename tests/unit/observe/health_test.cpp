#include "observe/health.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace matrigrate;

namespace {

/// A square cell of 10 um, and matrix particles where they are asked for.
State square_cell(const std::vector<Vec2>& particles) {
  State s;
  s.cells.emplace_back().cortex.x = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  s.cells[0].cortex.v.assign(4, Vec2::Zero());
  s.ecm.X = s.ecm.x = particles;
  s.ecm.v.assign(particles.size(), Vec2::Zero());
  s.ecm.rho.assign(particles.size(), 1.0);
  s.ecm.S.assign(particles.size(), Mat2::Zero());
  s.ecm.f.assign(particles.size(), 1.0);
  return s;
}

} // namespace

TEST(SolidInside, FindsParticlesAndTheirDepth) {
  State s = square_cell({{5, 9.5}, {3, 5}, {5, 5}, {11, 5}, {-20, 5}});
  s.ecm.f[2] = 0.0; // fluid may be there
  const SolidInside inside = solid_inside(s.ecm, s.cells[0].cortex);
  EXPECT_EQ(inside.n, 2U);
  EXPECT_NEAR(inside.deepest, 3.0, 1e-12);
}

TEST(SolidInside, IsNothingWithoutACell) {
  State s = square_cell({{5, 5}});
  s.cells.clear();
  EXPECT_EQ(HealthWatch{}.row(s, Parameters{}, {}).solid_inside, 0U);
}

TEST(HealthRow, TellsExtremesOfTheState) {
  State s = square_cell({{20, 0}, {30, 0}, {40, 0}});
  s.ecm.rho = {0.9, 1.2, 5.0};
  s.ecm.f = {1.0, 0.5, 0.0};
  s.ecm.v[1] = {0.3, 0.4};
  s.cells[0].cortex.v[2] = {0.0, 0.2};
  Parameters p;
  HealthWatch watch;
  const HealthRow row = watch.row(s, p, {});
  EXPECT_EQ(row.density_min, 0.9);
  EXPECT_EQ(row.density_max, 1.2) << "fluid is left out";
  EXPECT_NEAR(row.fastest, 0.5, 1e-12);
  EXPECT_NEAR(row.area_ratio, 100.0 / initial_area(p.cell), 1e-12);
  EXPECT_FALSE(row.crosses_itself);
  std::swap(s.cells[0].cortex.x[1], s.cells[0].cortex.x[2]);
  EXPECT_TRUE(watch.row(s, p, {}).crosses_itself);
}

TEST(Alarm, SaysWhatIsWrongAndWhere) {
  State s = square_cell({{20, 0}, {30, 0}});
  const Parameters p;
  const auto alarm_of = [&](HealthRow row) {
    if (std::isnan(row.area_ratio)) row.area_ratio = 1.0;
    return alarm(s, p, row);
  };
  const auto expect = [&](const HealthRow& row, FailureCause cause, const std::string& words) {
    const std::optional<Alarm> found = alarm_of(row);
    ASSERT_TRUE(found) << words;
    EXPECT_EQ(to_string(found->cause), to_string(cause)) << found->text;
    EXPECT_NE(found->text.find(words), std::string::npos) << found->text;
  };
  EXPECT_FALSE(alarm_of({}));
  expect({.crosses_itself = true}, FailureCause::crossing, "crosses itself");
  expect({.area_ratio = -1.0}, FailureCause::collapse, "of its area left");
  expect({.deepest_solid = 5.0}, FailureCause::solid_inside, "5 um deep");
  expect({.force_imbalance = 0.1}, FailureCause::imbalance, "do not balance");
  s.ecm.x[1].y() = std::numeric_limits<double>::quiet_NaN();
  expect({}, FailureCause::not_finite, "matrix particle 1");
  s.ecm.x[1] = {30, 0};
  s.cells[0].cortex.x[1].x() = std::numeric_limits<double>::infinity();
  expect({}, FailureCause::not_finite, "cortex");
}

TEST(HealthWatch, GathersTheStepsSinceTheLastRow) {
  const State s = square_cell({});
  const Parameters p;
  HealthWatch watch;
  StepHealth step;
  for (const int iterations : {3, 9, 5}) {
    step.solve.iterations = iterations;
    step.solve.residual = 1e-7 * iterations;
    watch.see(step);
  }
  step.orphans = 4;
  step.engulfed = 2;
  step.density_bounds = 1;
  const HealthRow row = watch.row(s, p, step);
  EXPECT_EQ(row.iterations, 5);
  EXPECT_EQ(row.max_iterations, 9);
  EXPECT_NEAR(row.residual, 5e-7, 1e-18);
  EXPECT_NEAR(row.largest_residual, 9e-7, 1e-18);
  EXPECT_EQ(row.orphans, 4U);
  EXPECT_EQ(row.engulfed, 2U);
  EXPECT_EQ(row.density_bounds, 1U);
  EXPECT_TRUE(std::isnan(row.density_min)) << "no solid";
  EXPECT_EQ(watch.row(s, p, step).max_iterations, 0) << "gathered anew";
}
