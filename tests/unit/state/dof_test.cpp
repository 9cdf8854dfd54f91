#include "state/dof.hpp"

#include <gtest/gtest.h>

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
    EXPECT_EQ(is_clamped(s, node), node == 1);
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
  std::vector<Vec2> v = node_velocities(s);
  EXPECT_EQ(v[5].x(), 30.0);
  EXPECT_EQ(v[8].x(), 16.0);
  EXPECT_EQ(of_nucleus(s, 0, std::span(v)).size(), 2U);
  EXPECT_EQ(of_nucleus(s, 0, std::span(v))[1].x(), 31.0);
  EXPECT_EQ(of_cell(s, 0, std::span(v)).size(), 3U);
  for (Vec2& velocity : v) velocity.y() = velocity.x();
  set_node_velocities(s, v);
  EXPECT_EQ(s.cells[0].nucleus.v[1].y(), 31.0);
  EXPECT_EQ(node_velocities(s), v);
}

TEST(Nodes, TakeTheirVelocitiesBack) {
  State s = small_state();
  std::vector<Vec2> v = node_velocities(s);
  for (Vec2& velocity : v) velocity.y() = 1.0;
  set_node_velocities(s, v);
  EXPECT_EQ(node_velocities(s), v);
  EXPECT_EQ(s.ecm.v.size(), 2U);
  EXPECT_EQ(s.cells[0].cortex.v.size(), 3U);
  EXPECT_EQ(s.cells[1].cortex.v[1], Vec2(16.0, 1.0));
}

TEST(Nodes, OfTheMatrixAloneAreItsParticles) {
  State s = small_state();
  s.cells.clear();
  EXPECT_EQ(node_count(s), 2U);
  EXPECT_EQ(node_velocities(s).size(), 2U);
}
