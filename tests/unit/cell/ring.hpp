#pragma once

// Rings to test forces on, and what every force of the cortex is tested for.

#include "base/vector.hpp"
#include "parameters/parameters.hpp"
#include "solve/drag_system.hpp"
#include "state/cortex.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

namespace matrigrate {

/// A small cell, with segments of 0.65 um.
inline CellParameters small_cell() {
  CellParameters p;
  p.radius = 5.0;
  p.particles = 48;
  return p;
}

/// A ring through the given points, unstretched.
inline CortexState polygon(std::vector<Vec2> corners) {
  CortexState c;
  c.x = std::move(corners);
  c.v.assign(c.size(), Vec2::Zero());
  for (std::size_t i = 0; i < c.size(); ++i) c.l0.push_back((c.x[c.next(i)] - c.x[i]).norm());
  return c;
}

/// The round cell in a shape without any symmetry, away from the origin, with uneven segments.
inline CortexState wavy_cortex(const CellParameters& p, double scale = 1.0) {
  CortexState c = round_cortex(p);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(c.size());
    const double angle = a + 0.04 * std::sin(5.0 * a + 1.0);
    const double r = scale * p.radius * (1.0 + 0.15 * std::cos(3.0 * a) + 0.04 * std::sin(7.0 * a));
    c.x[i] = Vec2(3.0 + r * std::cos(angle), -2.0 + r * std::sin(angle));
    c.l0[i] *= 1.0 + 0.1 * std::sin(2.0 * a);
  }
  return c;
}

/// A rectangle around the origin whose sides are cut into segments of the given length.
inline CortexState box(double width, double height, double segment) {
  const std::vector<Vec2> corners{{-0.5 * width, -0.5 * height},
                                  {0.5 * width, -0.5 * height},
                                  {0.5 * width, 0.5 * height},
                                  {-0.5 * width, 0.5 * height}};
  std::vector<Vec2> points;
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec2 edge = corners[(side + 1) % 4] - corners[side];
    const auto count = static_cast<int>(std::lround(edge.norm() / segment));
    for (int k = 0; k < count; ++k) points.push_back(corners[side] + edge * k / count);
  }
  return polygon(points);
}

/// A rigid motion of the plane.
struct Motion {
  Mat2 R = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  Vec2 shift{-12.0, 31.0};

  Vec2 operator()(const Vec2& x) const { return R * x + shift; }
};

inline CortexState moved(CortexState c, const Motion& motion) {
  for (Vec2& x : c.x) x = motion(x);
  return c;
}

inline constexpr double time_step = 0.4; ///< [s]

/// What a force adds to the forces and to the drag of a number of nodes.
struct Assembled {
  std::vector<Vec2> force;
  DragSystem A;
};

template <class Add>
Assembled assemble(std::size_t nodes, const Add& add) {
  Assembled a;
  a.force.assign(nodes, Vec2::Zero());
  a.A.diagonal.assign(nodes, 0.0);
  add(std::span<Vec2>(a.force), a.A);
  return a;
}

/// Drag force of all terms, and of the nodes' own drag, at the velocities v.
inline std::vector<Vec2> drag_force(const DragSystem& A, const std::vector<Vec2>& v) {
  std::vector<Vec2> f(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) f[i] = A.diagonal[i] * v[i];
  for (std::size_t m = 0; m < A.links.size(); ++m) {
    Vec2 rate = Vec2::Zero();
    for (std::uint32_t k = A.links.first[m]; k < A.links.first[m + 1]; ++k)
      rate += A.links.weight[k] * v[A.links.node[k]];
    for (std::uint32_t k = A.links.first[m]; k < A.links.first[m + 1]; ++k)
      f[A.links.node[k]] += A.links.c[m] * A.links.weight[k] * rate;
  }
  for (std::size_t m = 0; m < A.directed.size(); ++m) {
    double rate = 0.0;
    for (std::uint32_t k = A.directed.first[m]; k < A.directed.first[m + 1]; ++k)
      rate += A.directed.weight[k].dot(v[A.directed.node[k]]);
    for (std::uint32_t k = A.directed.first[m]; k < A.directed.first[m + 1]; ++k)
      f[A.directed.node[k]] += A.directed.c[m] * rate * A.directed.weight[k];
  }
  return f;
}

inline double power(const std::vector<Vec2>& force, const std::vector<Vec2>& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += force[i].dot(v[i]);
  return sum;
}

inline Vec2 net_force(const std::vector<Vec2>& force) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& f : force) sum += f;
  return sum;
}

inline double net_torque(const std::vector<Vec2>& force, const std::vector<Vec2>& x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += cross(x[i], force[i]);
  return sum;
}

inline double largest(const std::vector<Vec2>& force) {
  double most = 0.0;
  for (const Vec2& f : force) most = std::max(most, f.norm());
  return most;
}

/// Some velocities, different everywhere.
inline std::vector<Vec2> stirred(std::size_t nodes) {
  std::vector<Vec2> v;
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto a = static_cast<double>(i);
    v.emplace_back(std::sin(1.3 * a + 0.2), std::cos(2.1 * a));
  }
  return v;
}

/// A force of the cortex: adds for a ring whose particle 0 is node `first`.
using CortexForce = std::function<void(const CortexState&, std::uint32_t first, std::span<Vec2>, DragSystem&)>;

inline Assembled assemble(const CortexForce& add, const CortexState& c, std::uint32_t first = 0) {
  return assemble(first + c.size(), [&](std::span<Vec2> force, DragSystem& A) { add(c, first, force, A); });
}

/// What holds for every force within the ring: it acts, on the ring's nodes alone, without resultant or moment; its
/// drag conserves momentum; both turn with the ring.
inline void expect_internal(const CortexForce& add, const CortexState& c) {
  constexpr std::uint32_t first = 3;
  const Assembled here = assemble(add, c, first);
  const double scale = largest(here.force);
  ASSERT_GT(scale, 1e-9);
  for (std::uint32_t k = 0; k < first; ++k) EXPECT_EQ(here.force[k].norm(), 0.0);
  const std::vector<Vec2> own(here.force.begin() + first, here.force.end());
  EXPECT_LT(net_force(own).norm(), 1e-12 * scale);
  EXPECT_LT(std::abs(net_torque(own, c.x)), 1e-11 * scale);

  const std::vector<Vec2> v = stirred(first + c.size());
  const std::vector<Vec2> drag = drag_force(here.A, v);
  ASSERT_GT(largest(drag), 1e-9);
  for (std::uint32_t k = 0; k < first; ++k) EXPECT_EQ(drag[k].norm(), 0.0);
  EXPECT_LT(net_force(drag).norm(), 1e-12 * largest(drag));
  EXPECT_LT(largest(drag_force(here.A, std::vector<Vec2>(v.size(), Vec2(1.0, -2.0)))), 1e-12 * largest(drag));
  for (const double coefficient : here.A.directed.c) EXPECT_GE(coefficient, 0.0);

  const Motion motion;
  const Assembled there = assemble(add, moved(c, motion), first);
  std::vector<Vec2> turned = v;
  for (Vec2& a : turned) a = motion.R * a;
  const std::vector<Vec2> turned_drag = drag_force(there.A, turned);
  for (std::size_t i = 0; i < v.size(); ++i) {
    EXPECT_LT((there.force[i] - motion.R * here.force[i]).norm(), 1e-9 * scale);
    EXPECT_LT((turned_drag[i] - motion.R * drag[i]).norm(), 1e-9 * largest(drag));
  }
}

/// The forces are the negative gradient of the energy, by central differences.
template <class Energy>
void expect_minus_gradient(const std::vector<Vec2>& force, std::vector<Vec2>& x, const Energy& energy) {
  constexpr double h = 1e-5;
  const double scale = largest(force);
  ASSERT_GT(scale, 1e-9);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (int axis = 0; axis < 2; ++axis) {
      const double at = x[i][axis];
      x[i][axis] = at + h;
      const double above = energy();
      x[i][axis] = at - h;
      const double below = energy();
      x[i][axis] = at;
      EXPECT_NEAR(force[i][axis], -(above - below) / (2.0 * h), 1e-6 * scale) << "particle " << i << ", axis " << axis;
    }
}

/// Minus dt times the change of the forces with the ring moving at v: what a linearly implicit drag should add.
inline std::vector<Vec2> implicit_drag(const CortexForce& add, const CortexState& c, const std::vector<Vec2>& v,
                                       double dt) {
  constexpr double h = 1e-6;
  CortexState after = c;
  CortexState before = c;
  for (std::size_t i = 0; i < c.size(); ++i) {
    after.x[i] += h * v[i];
    before.x[i] -= h * v[i];
  }
  std::vector<Vec2> f = assemble(add, before).force;
  const std::vector<Vec2> g = assemble(add, after).force;
  for (std::size_t i = 0; i < f.size(); ++i) f[i] = dt * (f[i] - g[i]) / (2.0 * h);
  return f;
}

inline void expect_same(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double relative) {
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(largest(b), 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT((a[i] - b[i]).norm(), relative * largest(b)) << "node " << i;
}

} // namespace matrigrate
