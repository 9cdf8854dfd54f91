#include "contact/cells.hpp"

#include "../cell/ring.hpp"
#include "cell/geometry.hpp"
#include "state/dof.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

using namespace matrigrate;

namespace {

Parameters sticky() {
  Parameters p;
  p.contact.cells.adhesion = 0.1;
  return p;
}

/// Cells of a wavy outline, so that nothing holds by symmetry.
State cells_at(const Parameters& p, const std::vector<CellStart>& starts) {
  State s;
  for (const CellStart& start : starts) {
    Cell& cell = s.cells.emplace_back();
    cell.id = static_cast<std::uint32_t>(s.cells.size()) - 1;
    cell.cortex = round_cortex(p.cell, start);
    const Vec2 centre(start.x, start.y);
    for (Vec2& x : cell.cortex.x) {
      const Vec2 r = x - centre;
      x = centre + (1.0 + 0.01 * std::sin(5.0 * std::atan2(r.y(), r.x()) + cell.id)) * r;
    }
  }
  return s;
}

struct CellContact {
  std::vector<Vec2> force;
  DragSystem A;
};

CellContact contact_forces(const State& s, const Parameters& p) {
  CellContact a;
  a.force.assign(node_count(s), Vec2::Zero());
  add_cell_contact(s, cell_touches(s.cells, cell_reach(p.contact.cells)), p, time_step, a.force, a.A);
  return a;
}

double largest_force(const std::vector<Vec2>& force) {
  double most = 0.0;
  for (const Vec2& f : force) most = std::max(most, f.norm());
  return most;
}

} // namespace

TEST(CellContact, HasALawWithoutJumps) {
  const Parameters p = sticky();
  const CellContactParameters& law = p.contact.cells;
  EXPECT_EQ(cell_pressure(0.0, law), 0.5);
  EXPECT_EQ(cell_pressure(-1.0, law), 1.0) << "grows on inside the other cell";
  EXPECT_EQ(cell_pressure(1.0, law), 0.0);
  EXPECT_NEAR(cell_pressure(1.5, law), -0.1, 1e-15);
  EXPECT_NEAR(cell_pressure(1.25, law), -0.05, 1e-15);
  EXPECT_EQ(cell_pressure(2.0, law), 0.0);
  for (const double gap : {1.0, 1.5, 2.0})
    EXPECT_NEAR(cell_pressure(gap - 1e-9, law), cell_pressure(gap + 1e-9, law), 1e-8);
  EXPECT_EQ(cell_reach(law), 2.0);
  EXPECT_EQ(cell_reach(Parameters{}.contact.cells), 1.0) << "no adhesion without being asked for";
}

TEST(CellContact, LeavesCellsThatAreApartAlone) {
  const Parameters p = sticky();
  for (const double distance : {33.0, 60.0, 300.0}) {
    const State s = cells_at(p, {{0.0, 0.0}, {distance, 0.0}});
    const CellContact a = contact_forces(s, p);
    EXPECT_EQ(largest_force(a.force), 0.0);
    EXPECT_EQ(a.A.directed.size(), 0U);
  }
  EXPECT_TRUE(cell_touches(cells_at(p, {{0.0, 0.0}}).cells, 2.0).empty());
}

TEST(CellContact, PushesCellsApartAndPullsThemTogether) {
  const Parameters p = sticky();
  const auto push = [&](double distance) {
    const State s = cells_at(p, {{0.0, 0.0}, {distance, 0.0}});
    const std::vector<Vec2> force = contact_forces(s, p).force;
    const auto on_second = of_cell(s, 1, std::span(force));
    return std::accumulate(on_second.begin(), on_second.end(), Vec2(0.0, 0.0)).x();
  };
  EXPECT_GT(push(30.2), 0.1);
  EXPECT_GT(push(29.0), push(30.2)) << "overlapping cells are pushed out";
  EXPECT_LT(push(31.6), -0.01);
}

TEST(CellContact, ObeysTheThirdLawToRoundOff) {
  const Parameters p = sticky();
  const State s = cells_at(p, {{0.0, 0.0}, {30.3, 2.0}, {14.0, 27.0}, {200.0, 0.0}});
  const std::vector<Vec2> force = contact_forces(s, p).force;
  ASSERT_GT(largest_force(force), 1e-2);
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    sum += force[i];
    torque += cross(node_position(s, i), force[i]);
    magnitude += force[i].norm();
  }
  EXPECT_LT(sum.norm(), 1e-14 * magnitude);
  EXPECT_LT(std::abs(torque), 1e-12 * magnitude);
}

namespace {

/// Integral of cell_pressure(), which is linear between its corners, from a gap to infinity [kPa um].
double work(double gap, const CellContactParameters& law) {
  double sum = 0.0;
  for (const double corner :
       {0.0, law.repulsion_range, law.repulsion_range + 0.5 * law.adhesion_range, cell_reach(law)}) {
    if (corner <= gap) continue;
    sum += 0.5 * (corner - gap) * (cell_pressure(gap, law) + cell_pressure(corner, law));
    gap = corner;
  }
  return sum;
}

} // namespace

TEST(CellContact, IsMinusTheGradientOfItsEnergy) {
  const Parameters p = sticky();
  for (const double distance : {29.8, 30.4, 31.5}) {
    State s = cells_at(p, {{0.0, 0.0}, {distance, 1.0}});
    const std::vector<Vec2> force = contact_forces(s, p).force;
    const auto energy = [&] {
      double sum = 0.0;
      for (const CellTouch& t : cell_touches(s.cells, cell_reach(p.contact.cells))) sum += work(t.gap, p.contact.cells);
      return 0.5 * initial_segment_length(p.cell) * p.ecm.thickness * sum;
    };
    const double h = 1e-6;
    for (Cell& cell : s.cells)
      for (std::size_t i = 0; i < cell.cortex.size(); i += 3)
        for (int e = 0; e < 2; ++e) {
          double& x = cell.cortex.x[i][e];
          const double at = x;
          x = at + h;
          const double more = energy();
          x = at - h;
          const double less = energy();
          x = at;
          const Vec2& f = force[cell.id * p.cell.particles + i];
          EXPECT_NEAR(f[e], -(more - less) / (2.0 * h), 1e-5 * (largest_force(force) + 1e-3)) << cell.id << " " << i;
        }
  }
}

TEST(CellContact, RotatesWithTheCells) {
  const Parameters p = sticky();
  State s = cells_at(p, {{0.0, 0.0}, {30.3, 2.0}});
  const std::vector<Vec2> before = contact_forces(s, p).force;
  Mat2 turn;
  turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  for (Cell& cell : s.cells)
    for (Vec2& x : cell.cortex.x) x = turn * x;
  const std::vector<Vec2> after = contact_forces(s, p).force;
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((after[i] - turn * before[i]).norm(), 1e-12 * largest_force(before)) << i;
}

TEST(CellContact, FindsThePairsThatAllAgainstAllFind) {
  const Parameters p;
  std::vector<CellStart> starts;
  for (int k = 0; k < 40; ++k) {
    const int row = k / 7;
    starts.push_back({31.0 * (k % 7) - 90.0 + 3.0 * std::sin(k), 31.0 * row - 90.0});
  }
  const State s = cells_at(p, starts);
  const std::vector<CellTouch> found = cell_touches(s.cells, 3.0);
  std::size_t expected = 0;
  for (std::uint32_t k = 0; k < s.cells.size(); ++k)
    for (std::uint32_t other = 0; other < s.cells.size(); ++other) {
      if (k == other) continue;
      const CortexState& c = s.cells[other].cortex;
      for (const Vec2& x : s.cells[k].cortex.x) {
        bool near = false;
        for (std::size_t i = 0; i < c.size(); ++i)
          near = near || closest_point(x, c.x[i], c.x[c.next(i)]).from.norm() < 3.0;
        expected += near ? 1 : 0;
      }
    }
  EXPECT_GT(expected, 100U);
  EXPECT_EQ(found.size(), expected);
  EXPECT_TRUE(std::ranges::is_sorted(found, {}, [](const CellTouch& t) {
    return std::array{t.cell, t.other, t.particle};
  }));
}
