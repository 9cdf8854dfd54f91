#include "observe/frame.hpp"

#include "base/failure.hpp"
#include "ecm/law/material.hpp"
#include "ecm/loop/fluid.hpp"
#include "frames.hpp"
#include "sph/neighbours.hpp"
#include "unit/observe/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
  EXPECT_EQ(f.outline.cell[n - 1], 1U);
  EXPECT_EQ(f.outline.cell[n], 5U) << "the id, counted from 1";
  EXPECT_EQ(f.protrusions.id, (Counts{1, 2, 1}));
  EXPECT_EQ(f.protrusions.cell, (Counts{1, 1, 5}));
  EXPECT_EQ(f.outline.protrusion[10], 0);
  EXPECT_EQ(f.outline.protrusion[n + 10], 2) << "among those of all cells";
  EXPECT_EQ(f.outline.phase[n + 10], 0);
  EXPECT_EQ(f.outline.protrusion[n + 60], of_none);
  EXPECT_TRUE(SmallRun().film().frames[0].outline.cell.empty());
  EXPECT_EQ(as_counts(as_floats(f.outline.cell)), f.outline.cell);
  for (const float number : {-1.0F, 1.5F, 1e9F, NAN}) EXPECT_THROW(as_counts({number}), InputOutputError) << number;
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
  EXPECT_EQ(f.protrusions.id, (Counts{1, 2}));
  EXPECT_EQ(f.protrusions.centre, (Counts{10, 60}));
  EXPECT_EQ(f.protrusions.phase, (Bytes{0, 2}));
  EXPECT_TRUE(std::isnan(f.protrusions.anchor[0]));
  EXPECT_EQ(f.protrusions.anchor[2], 30.5F);
  EXPECT_EQ(f.protrusions.f_mat, (Floats{0, 0.75F}));
  EXPECT_EQ(f.protrusions.force[0], 0.0F);
  EXPECT_GT(f.protrusions.force[1], 0.0F);
}

} // namespace
} // namespace matrigrate::observe
