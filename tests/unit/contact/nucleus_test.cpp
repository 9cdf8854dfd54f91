#include "contact/nucleus.hpp"

#include "cell/nucleus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

using namespace matrigrate;

namespace nucleus_test {

namespace {

constexpr double dt = 0.4;

Parameters with_nucleus() {
  Parameters p;
  p.nucleus.radius = 5.0;
  return p;
}

/// A cell whose cortex lies `gap` around its nucleus on average, both wavy, and the nucleus off the middle.
Cell tight_cell(const Parameters& p, double gap, const Vec2& off = Vec2(0.1, -0.2)) {
  Cell cell;
  cell.cortex = round_cortex(p.cell);
  cell.nucleus = round_nucleus(p, {});
  for (Vec2& x : cell.cortex.x)
    x *= (p.nucleus.radius + gap) / p.cell.radius * (1.0 + 0.02 * std::sin(5.0 * std::atan2(x.y(), x.x())));
  for (Vec2& x : cell.nucleus.x) x = x * (1.0 + 0.01 * std::cos(3.0 * std::atan2(x.y(), x.x()))) + off;
  return cell;
}

struct Assembled {
  std::vector<Vec2> force; ///< on the cortex, then on the nucleus
  DragSystem A;
};

Assembled contact(const Cell& cell, const Parameters& p) {
  Assembled a;
  a.force.assign(cell.cortex.size() + cell.nucleus.size(), Vec2::Zero());
  add_nucleus_contact(cell, nucleus_touches(cell, p.nucleus), p, dt, 0, static_cast<std::uint32_t>(cell.cortex.size()),
                      a.force, a.A);
  return a;
}

Assembled centring(const Cell& cell, const Parameters& p) {
  Assembled a;
  a.force.assign(cell.cortex.size() + cell.nucleus.size(), Vec2::Zero());
  add_centring(cell, p.nucleus, dt, 0, static_cast<std::uint32_t>(cell.cortex.size()), a.force, a.A);
  return a;
}

Vec2& place(Cell& cell, std::size_t node) {
  return node < cell.cortex.size() ? cell.cortex.x[node] : cell.nucleus.x[node - cell.cortex.size()];
}

Vec2 sum_on_nucleus(const Cell& cell, const std::vector<Vec2>& force) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = cell.cortex.size(); i < force.size(); ++i) sum += force[i];
  return sum;
}

double largest(const std::vector<Vec2>& force) {
  double most = 0.0;
  for (const Vec2& f : force) most = std::max(most, f.norm());
  return most;
}

void expect_balance(Cell cell, const std::vector<Vec2>& force) {
  Vec2 sum = Vec2::Zero();
  double torque = 0.0, magnitude = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    sum += force[i];
    torque += cross(place(cell, i), force[i]);
    magnitude += force[i].norm();
  }
  ASSERT_GT(largest(force), 1e-5);
  EXPECT_LT(sum.norm(), 1e-14 * magnitude);
  EXPECT_LT(std::abs(torque), 1e-12 * magnitude);
}

/// Weights of the terms times a velocity of all nodes that is the same everywhere: no drag against that.
template <class Weight>
void expect_no_drag_of_translation(const DragTerms<Weight>& terms) {
  for (std::size_t m = 0; m < terms.size(); ++m) {
    Weight sum = terms.weight[terms.first[m]];
    for (std::uint32_t k = terms.first[m] + 1; k < terms.first[m + 1]; ++k) sum += terms.weight[k];
    if constexpr (std::is_same_v<Weight, double>)
      EXPECT_NEAR(sum, 0.0, 1e-13);
    else
      EXPECT_LT(sum.norm(), 1e-13);
  }
}

} // namespace

TEST(NucleusContact, HasTheLawOfCells) {
  const NucleusParameters n;
  EXPECT_EQ(nucleus_pressure(0.0, n), 2.0);
  EXPECT_EQ(nucleus_pressure(0.25, n), 1.0);
  EXPECT_EQ(nucleus_pressure(0.5, n), 0.0);
  EXPECT_EQ(nucleus_pressure(0.7, n), 0.0);
  EXPECT_EQ(nucleus_pressure(-0.5, n), 4.0) << "grows on where they overlap";
}

TEST(NucleusContact, LeavesARoomyCellAlone) {
  const Parameters p = with_nucleus();
  EXPECT_TRUE(nucleus_touches(tight_cell(p, 2.0), p.nucleus).empty());
  Cell without = tight_cell(p, 0.2);
  without.nucleus = {};
  EXPECT_TRUE(nucleus_touches(without, p.nucleus).empty());
}

TEST(NucleusContact, ObeysTheThirdLawToRoundOff) {
  const Parameters p = with_nucleus();
  const Cell cell = tight_cell(p, 0.3);
  const Assembled a = contact(cell, p);
  expect_balance(cell, a.force);
  EXPECT_GT(sum_on_nucleus(cell, a.force).norm(), 1e-3);
  expect_no_drag_of_translation(a.A.directed);
}

TEST(NucleusContact, IsMinusTheGradientOfItsEnergy) {
  const Parameters p = with_nucleus();
  const auto energy = [&p](const Cell& cell) { // work against the pressure, which is linear in the gap
    double sum = 0.0;
    for (const NucleusTouch& t : nucleus_touches(cell, p.nucleus)) {
      CellParameters ring = p.cell;
      if (t.of_nucleus) {
        ring.radius = p.nucleus.radius;
        ring.particles = p.nucleus.particles;
      }
      const double length = initial_segment_length(ring);
      sum += 0.5 * length * p.ecm.thickness * 0.5 * nucleus_pressure(t.gap, p.nucleus)
             * (p.nucleus.repulsion_range - t.gap);
    }
    return sum;
  };
  for (const double gap : {0.3, 0.0}) { // the second one overlaps in places
    Cell cell = tight_cell(p, gap);
    const std::vector<Vec2> force = contact(cell, p).force;
    const double h = 1e-6;
    for (std::size_t i = 0; i < force.size(); i += 4)
      for (int e = 0; e < 2; ++e) {
        double& x = place(cell, i)[e];
        const double at = x;
        x = at + h;
        const double more = energy(cell);
        x = at - h;
        const double less = energy(cell);
        x = at;
        EXPECT_NEAR(force[i][e], -(more - less) / (2.0 * h), 1e-4 * largest(force)) << gap << " " << i;
      }
  }
}

TEST(NucleusContact, PushesTheNucleusAwayFromTheNearSide) {
  const Parameters p = with_nucleus();
  const Cell near_right = tight_cell(p, 0.6, {0.4, 0.0});
  EXPECT_LT(sum_on_nucleus(near_right, contact(near_right, p).force).x(), -1e-2);
  const Cell through = tight_cell(p, 0.6, {1.0, 0.0}); // sticks out to the right
  EXPECT_TRUE(nucleus_outside(through));
  EXPECT_FALSE(nucleus_outside(near_right));
  EXPECT_LT(sum_on_nucleus(through, contact(through, p).force).x(),
            sum_on_nucleus(near_right, contact(near_right, p).force).x());
}

TEST(NucleusContact, PressesAsMuchAsThePressureSays) {
  const Parameters p = with_nucleus();
  Cell cell;
  cell.cortex = round_cortex(p.cell);
  for (Vec2& x : cell.cortex.x) x *= 5.25 / p.cell.radius;
  cell.nucleus = round_nucleus(p, {});
  const std::vector<Vec2> force = contact(cell, p).force;
  double outward = 0.0;
  for (std::size_t i = 0; i < cell.cortex.size(); ++i) outward += force[i].dot(cell.cortex.x[i].normalized());
  // Half by each sampled side; of the cortex l_0,init is that of its own round shape, 15 um in radius.
  const double widths = 0.5 * 2.0 * std::numbers::pi * (p.cell.radius + p.nucleus.radius);
  EXPECT_NEAR(outward, 1.0 * widths, 0.03 * widths);
}

TEST(NucleusCentring, PullsTheNucleusToTheMiddle) {
  const Parameters p = with_nucleus();
  const Cell cell = tight_cell(p, 3.0, {2.0, 0.0});
  const Assembled a = centring(cell, p);
  EXPECT_NEAR(sum_on_nucleus(cell, a.force).x(), -0.02 * 2.0, 1e-3);
  EXPECT_NEAR((sum_on_nucleus(cell, a.force) - p.nucleus.centring_stiffness * off_centre(cell)).norm(), 0.0, 1e-14);
  expect_balance(cell, a.force);
  expect_no_drag_of_translation(a.A.links);
  ASSERT_EQ(a.A.links.size(), 1U);
  EXPECT_DOUBLE_EQ(a.A.links.c[0], p.nucleus.drag + dt * p.nucleus.centring_stiffness);
}

} // namespace nucleus_test
