#include "base/failure.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/fluid.hpp"
#include "frames.hpp"
#include "observe/frame.hpp"
#include "observe/health.hpp"
#include "sph/neighbours.hpp"
#include "state/initial.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace matrigrate;

namespace matrigrate::observe {
namespace {

TEST(Frame, HoldsTheFieldsOfAState) {
  const SmallRun run;
  const Frame f = run.film().frames[0];
  const std::size_t n = run.s.ecm.size();
  EXPECT_EQ(f.t, 300.0);
  ASSERT_EQ(f.matrix.displacement.size(), 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(f.matrix.displacement[2 * i], 0.01 * run.s.ecm.X[i].x(), 4e-5);
    EXPECT_NEAR(f.matrix.velocity[2 * i + 1], 1e-3 * run.s.ecm.X[i].y(), 3e-4 * std::abs(run.s.ecm.v[i].y()));
  }
  const double Pa = 1e3;
  EXPECT_NEAR(f.matrix.pressure[0], Pa * pressure(1.01, moduli(run.p.ecm).K), 1e-3);
  EXPECT_NEAR(f.matrix.von_mises[0], Pa * von_mises(run.s.ecm.S[0]), 1e-2);
  EXPECT_EQ(f.matrix.von_mises[3], 0.0F) << "fluid";
  EXPECT_EQ(f.matrix.f_degr[4], 0.5F);
  EXPECT_TRUE(f.matrix.fibre_von_mises.empty());
}

TEST(Frame, HoldsThePressureOfTheFluidWhereItIs) {
  SmallRun run;
  EcmState& ecm = run.s.ecm;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.x[i] = 0.97 * ecm.X[i];
    ecm.f[i] = 0.0;
  }
  const Kernel kernel(run.p.ecm.smoothing_length);
  const Adjacency pairs = neighbours_within(ecm.x, kernel.support(), 0.0);
  const Floats pressed = run.film().frames[0].matrix.pressure;
  std::size_t under_pressure = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const double expected = 1e3 * fluid_pressure(ecm, run.p.ecm, pairs, kernel, lattice_density(run.p.ecm), i);
    EXPECT_NEAR(pressed[i], expected, 1e-3 * expected) << i;
    under_pressure += expected > 1.0 ? 1 : 0; // Pa
  }
  EXPECT_GT(under_pressure, ecm.size() / 2) << "all but those at the edges";
}

TEST(Frame, HoldsTheFibresWhereThereAreAny) {
  SmallRun run;
  run.p.fibres.arrangement = FibreArrangement::isotropic;
  const Frame f = run.film().frames[0];
  ASSERT_EQ(f.matrix.fibre_von_mises.size(), run.s.ecm.size());
  EXPECT_EQ(f.matrix.fibre_von_mises[3], 0.0F) << "fluid";
  EXPECT_GT(f.matrix.fibre_von_mises[0], 0.0F) << "stretched";
}

TEST(Frame, HoldsOneCellAfterTheOther) {
  const TwoCells run;
  const Frame f = run.film().frames[0];
  const std::size_t n = run.s.cells[0].cortex.size();
  EXPECT_EQ(outline_ends(f.outline), (std::vector<std::size_t>{n, 2 * n}));
  EXPECT_EQ(f.outline.x[2 * n], static_cast<float>(run.s.cells[1].cortex.x[0].x()));
  EXPECT_EQ(f.outline.cell[n - 1], 1.0F);
  EXPECT_EQ(f.outline.cell[n], 5.0F) << "the id, counted from 1";
  EXPECT_EQ(f.protrusions.id, (Floats{1, 2, 1}));
  EXPECT_EQ(f.protrusions.cell, (Floats{1, 1, 5}));
  EXPECT_EQ(f.outline.protrusion[10], 0);
  EXPECT_EQ(f.outline.protrusion[n + 10], 2) << "among those of all cells";
  EXPECT_EQ(f.outline.phase[n + 10], 0);
  EXPECT_EQ(f.outline.protrusion[n + 60], of_none);
  EXPECT_TRUE(SmallRun().film().frames[0].outline.cell.empty());
}

TEST(Frame, TellsTheEndsOfCellsFromAsManyNumbersAsThereAre) {
  OutlineFrame outline = SmallRun().film().frames[0].outline;
  outline.front = {1, 1, 1};
  outline.cell = {1, 2, 3};
  EXPECT_EQ(outline_ends(outline), (std::vector<std::size_t>{1, 2, 3}));
  outline.cell.resize(1); // the others are still in memory
  EXPECT_EQ(outline_ends(outline), (std::vector<std::size_t>{3}));
}

TEST(Frame, HoldsTheForceOfActomyosinUnderTheLawThatRuns) {
  SmallRun run;
  const auto most = [&] { return std::ranges::max(run.film().frames[0].outline.force); };
  EXPECT_GT(most(), 0.0F);
  run.p.laws.curvature_factor = "0";
  EXPECT_EQ(most(), 0.0F);
}

TEST(Frame, HoldsTheCellAndItsProtrusions) {
  const SmallRun run;
  const Frame f = run.film().frames[0];
  EXPECT_EQ(f.outline.protrusion[10], 0);
  EXPECT_EQ(f.outline.protrusion[60], 1);
  EXPECT_EQ(f.outline.protrusion[35], of_none);
  EXPECT_EQ(f.outline.phase[60], 2);
  EXPECT_EQ(std::count(f.outline.front.begin(), f.outline.front.end(), 1),
            static_cast<std::ptrdiff_t>(run.s.cells[0].cortex.size() / 2));
  EXPECT_EQ(f.protrusions.id, (Floats{1, 2}));
  EXPECT_EQ(f.protrusions.centre, (Floats{10, 60}));
  EXPECT_EQ(f.protrusions.phase, (Bytes{0, 2}));
  EXPECT_TRUE(std::isnan(f.protrusions.anchor[0]));
  EXPECT_EQ(f.protrusions.anchor[2], 30.5F);
  EXPECT_EQ(f.protrusions.f_mat, (Floats{0, 0.75F}));
  EXPECT_EQ(f.protrusions.force[0], 0.0F);
  EXPECT_GT(f.protrusions.force[1], 0.0F);
}

} // namespace
} // namespace matrigrate::observe

TEST(Fields, OfAStretchedGelWithAHoleOfFluid) {
  const EcmParameters p;
  FibreParameters fibres;
  fibres.arrangement = FibreArrangement::isotropic;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const FibreNetwork network(ecm, p, fibres, Reference(ecm, p));
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    ecm.x[i].x() *= 1.05;
    if (ecm.X[i].norm() < 6.0) ecm.f[i] = 0.0;
  }
  const std::vector<double> stress = fibre_stress_field(ecm, fibres, network);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(std::isnan(stress[i]), ecm.f[i] == 0.0);
    if (ecm.f[i] > 0.0) {
      EXPECT_GT(stress[i], 1e-3);
    }
  }
  EXPECT_TRUE(std::isnan(fibre_stress_field(ecm, fibres, FibreNetwork()).front()));
}

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
