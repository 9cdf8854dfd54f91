#include "state/dof.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace matrigrate;

namespace {

/// Two particles of the matrix, a cell of three and one of two particles.
State small_state() {
  State s;
  s.ecm.X = s.ecm.x = {{0, 0}, {1, 0}};
  s.ecm.v = {{10, 0}, {11, 0}};
  s.ecm.clamped = {0, 1};
  s.cells.resize(2);
  s.cells[0].cortex.x = {{2, 0}, {3, 0}, {4, 0}};
  s.cells[0].cortex.v = {{12, 0}, {13, 0}, {14, 0}};
  s.cells[1].cortex.x = {{5, 0}, {6, 0}};
  s.cells[1].cortex.v = {{15, 0}, {16, 0}};
  return s;
}

} // namespace

TEST(Nodes, AreTheMatrixAndThenTheCellsInTheirOrder) {
  const State s = small_state();
  EXPECT_EQ(node_count(s), 7U);
  EXPECT_EQ(first_node(s, 0), 2U);
  EXPECT_EQ(first_node(s, 1), 5U);
  const std::vector<Vec2> v = node_velocities(s);
  ASSERT_EQ(v.size(), 7U);
  for (std::size_t node = 0; node < 7; ++node) {
    EXPECT_EQ(node_position(s, node).x(), static_cast<double>(node));
    EXPECT_EQ(v[node].x(), 10.0 + static_cast<double>(node));
    EXPECT_EQ(in_matrix(s, node), node < 2);
  }
}

TEST(Nodes, OfACellAreItsOwn) {
  const State s = small_state();
  const std::vector<Vec2> v = node_velocities(s);
  const std::span<const Vec2> second = of_cell(s, 1, std::span(v));
  ASSERT_EQ(second.size(), 2U);
  EXPECT_EQ(second[0].x(), 15.0);
}

TEST(Nodes, OfANucleusFollowThoseOfItsCortex) {
  State s = small_state();
  s.cells[0].nucleus.x = {{20, 0}, {21, 0}};
  s.cells[0].nucleus.v = {{30, 0}, {31, 0}};
  EXPECT_EQ(node_count(s), 9U);
  EXPECT_EQ(cortex_particles(s), 5U);
  EXPECT_EQ(first_nucleus_node(s, 0), 5U);
  EXPECT_EQ(first_node(s, 1), 7U);
  EXPECT_EQ(node_position(s, 6).x(), 21.0);
  EXPECT_EQ(node_position(s, 8).x(), 6.0);
  const std::vector<Vec2> v = node_velocities(s);
  EXPECT_EQ(v[5].x(), 30.0);
  EXPECT_EQ(v[8].x(), 16.0);
  EXPECT_EQ(of_nucleus(s, 0, std::span(v)).size(), 2U);
  EXPECT_EQ(of_nucleus(s, 0, std::span(v))[1].x(), 31.0);
  EXPECT_EQ(of_cell(s, 0, std::span(v)).size(), 3U);
}

TEST(Nodes, OfTheMatrixAloneAreItsParticles) {
  State s = small_state();
  s.cells.clear();
  EXPECT_EQ(node_count(s), 2U);
  EXPECT_EQ(node_velocities(s).size(), 2U);
}

TEST(Disc, HasTheNumberOfParticlesOfThePaper) {
  Parameters p;
  p.ecm.cell_hole = false;
  const EcmState ecm = disc(p);
  EXPECT_EQ(ecm.size(), 17665U); // lattice points within 75 spacings of the origin
  EXPECT_EQ(std::count(ecm.clamped.begin(), ecm.clamped.end(), 0), 16461);
}

TEST(Disc, ClampsTheRimAndFluidizesTheHole) {
  Parameters p;
  p.ecm.radius = 60.0;
  const EcmState ecm = disc(p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(ecm.clamped[i] == 1, ecm.X[i].norm() > 60.0 - 5.2);
    EXPECT_EQ(ecm.f[i] == 0.0, ecm.X[i].norm() < 15.0 + 1.9);
  }
}

TEST(Disc, HexagonalLatticeHasSixNeighboursAtOneSpacing) {
  EcmParameters ecm;
  ecm.lattice = Lattice::hexagonal;
  int at_one_spacing = 0;
  for (const Vec2& X : lattice_patch(ecm, 1.01 * ecm.particle_spacing))
    if (X.norm() > 0.0) ++at_one_spacing;
  EXPECT_EQ(at_one_spacing, 6);
  EXPECT_DOUBLE_EQ(particle_area(ecm), 4.0 * std::sqrt(3.0) / 2.0);
}

TEST(Strip, IsSymmetricBetweenWallsAsDeepAsASupport) {
  for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
    EcmParameters p;
    p.lattice = lattice;
    const EcmState ecm = strip(p, 30.0, 40.0);
    double low = 0.0, high = 0.0, free_high = 0.0, wall_low = 1e9;
    for (std::size_t i = 0; i < ecm.size(); ++i) {
      low = std::min(low, ecm.X[i].y());
      high = std::max(high, ecm.X[i].y());
      if (ecm.clamped[i])
        wall_low = std::min(wall_low, std::abs(ecm.X[i].y()));
      else
        free_high = std::max(free_high, std::abs(ecm.X[i].y()));
    }
    EXPECT_NEAR(low, -high, 1e-12);
    EXPECT_LT(free_high, wall_low);
    EXPECT_GE(high - free_high, 2.0 * p.smoothing_length);
    EXPECT_DOUBLE_EQ(ecm.period_x, 30.0);
  }
}

TEST(Rectangle, IsCentredAndHeldAtBothEnds) {
  const EcmState ecm = rectangle(EcmParameters{}, 60.0, 20.0, 5.0);
  EXPECT_EQ(ecm.size(), 300U);
  Vec2 mean = Vec2::Zero();
  for (const Vec2& X : ecm.X) mean += X / 300.0;
  EXPECT_NEAR(mean.norm(), 0.0, 1e-12);
  for (std::size_t i = 0; i < ecm.size(); ++i) EXPECT_EQ(ecm.clamped[i] == 1, std::abs(ecm.X[i].x()) > 25.0);
}

TEST(MatrixFields, GiveEachParticleItsProperties) {
  Parameters p;
  p.ecm.radius = 30.0;
  EcmState ecm = disc(p);
  apply({.E_ratio = [](const Vec2& X) { return X.x() > 0.0 ? 2.0 : 1.0; }, .f_degr = [](const Vec2&) { return 0.5; }},
        ecm);
  ASSERT_EQ(ecm.E_ratio.size(), ecm.size());
  EXPECT_TRUE(ecm.fibre_direction.empty());
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(ecm.stiffness(i), ecm.X[i].x() > 0.0 ? 2.0 : 1.0);
    const bool hole = ecm.X[i].norm() < p.cell.radius;
    EXPECT_EQ(ecm.f[i], ecm.clamped[i] ? 1.0 : hole ? 0.0 : ecm.f[i]);
    EXPECT_TRUE(ecm.clamped[i] || ecm.f[i] <= 0.5);
  }
}

TEST(MatrixFields, RefuseValuesOutOfRange) {
  Parameters p;
  p.ecm.radius = 30.0;
  EcmState ecm = disc(p);
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(apply({.E_ratio = [&](const Vec2&) { return wrong; }}, ecm), std::invalid_argument) << wrong;
  for (const double wrong : {-0.1, 1.1})
    EXPECT_THROW(apply({.f_degr = [&](const Vec2&) { return wrong; }}, ecm), std::invalid_argument) << wrong;
}
