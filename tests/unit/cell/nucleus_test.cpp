#include "cell/nucleus.hpp"

#include "cell/geometry.hpp"
#include "ring.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

using namespace matrigrate;

namespace nucleus_test {

namespace {

constexpr double dt = 0.4;

Parameters with_nucleus(double radius = 5.0) {
  Parameters p;
  p.nucleus.radius = radius;
  return p;
}

struct Assembled {
  std::vector<Vec2> force;
  DragSystem A;
};

Assembled assemble(const CortexState& nucleus, const Parameters& p) {
  Assembled a;
  a.force.assign(nucleus.size(), Vec2::Zero());
  add_nucleus(nucleus, p, dt, 0, a.force, a.A);
  return a;
}

/// The round nucleus, drawn along x by a strain at constant area.
CortexState drawn(const Parameters& p, double strain) {
  CortexState c = round_nucleus(p, {0.0, 0.0});
  for (Vec2& x : c.x) x = Vec2((1.0 + strain) * x.x(), x.y() / (1.0 + strain));
  return c;
}

/// Goes on for a time, every particle with some drag of its own.
void relax(CortexState& c, const Parameters& p, double time) {
  const auto n = static_cast<long>(2 * c.size());
  for (double t = 0.0; t < time; t += dt) {
    const Assembled a = assemble(c, p);
    Eigen::MatrixXd A = 0.04 * Eigen::MatrixXd::Identity(n, n);
    Eigen::VectorXd F(n);
    for (std::size_t i = 0; i < c.size(); ++i) F.segment<2>(static_cast<long>(2 * i)) = a.force[i];
    for (std::size_t m = 0; m < a.A.directed.size(); ++m) {
      Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
      for (std::uint32_t k = a.A.directed.first[m]; k < a.A.directed.first[m + 1]; ++k)
        w.segment<2>(2L * a.A.directed.node[k]) += a.A.directed.weight[k];
      A += a.A.directed.c[m] * w * w.transpose();
    }
    const Eigen::VectorXd v = A.llt().solve(F);
    for (std::size_t i = 0; i < c.size(); ++i) c.x[i] += dt * v.segment<2>(static_cast<long>(2 * i));
  }
}

} // namespace

TEST(Nucleus, IsThereOnlyWhereAskedFor) {
  EXPECT_FALSE(has_nucleus(Parameters{}));
  EXPECT_EQ(round_nucleus(Parameters{}, {}).size(), 0U);
  const CortexState c = round_nucleus(with_nucleus(), {7.0, -3.0});
  ASSERT_EQ(c.size(), 72U);
  EXPECT_NEAR((centroid(c) - Vec2(7.0, -3.0)).norm(), 0.0, 1e-12);
  for (const Vec2& x : c.x) EXPECT_NEAR((x - Vec2(7.0, -3.0)).norm(), 5.0, 1e-12);
}

TEST(Nucleus, IsAtRestWhereItStarts) {
  for (const int particles : {72, 73}) {
    Parameters p = with_nucleus();
    p.nucleus.particles = particles;
    const CortexState c = round_nucleus(p, {7.0, -3.0});
    EXPECT_LT(largest(assemble(c, p).force), 1e-12) << particles;
    EXPECT_NEAR(nucleus_energy(c, p), 0.0, 1e-20);
  }
}

TEST(Nucleus, IsMinusTheGradientOfItsEnergy) {
  const Parameters p = with_nucleus();
  CortexState c = wavy_cortex(lamina(p), 0.9);
  const std::vector<Vec2> force = assemble(c, p).force;
  const double h = 1e-6;
  for (std::size_t i = 0; i < c.size(); i += 5)
    for (int e = 0; e < 2; ++e) {
      const double at = c.x[i][e];
      c.x[i][e] = at + h;
      const double more = nucleus_energy(c, p);
      c.x[i][e] = at - h;
      const double less = nucleus_energy(c, p);
      c.x[i][e] = at;
      EXPECT_NEAR(force[i][e], -(more - less) / (2.0 * h), 1e-6 * largest(force)) << i;
    }
}

TEST(Nucleus, HasNoResultantAndNoMoment) {
  const Parameters p = with_nucleus();
  const CortexState c = wavy_cortex(lamina(p), 0.9);
  const std::vector<Vec2> force = assemble(c, p).force;
  Vec2 sum = Vec2::Zero();
  double torque = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    sum += force[i];
    torque += cross(c.x[i], force[i]);
  }
  ASSERT_GT(largest(force), 1e-2);
  EXPECT_LT(sum.norm(), 1e-13 * static_cast<double>(c.size()) * largest(force));
  EXPECT_LT(std::abs(torque), 1e-12 * static_cast<double>(c.size()) * largest(force));
}

TEST(Nucleus, StoresTheEnergyOfAnElasticDisc) {
  Parameters p = with_nucleus();
  p.nucleus.stretch_stiffness = 1e-9;
  p.nucleus.bending_stiffness = 0.0;
  const double strain = 1e-3;
  const double area = std::numbers::pi * 25.0;
  EXPECT_NEAR(nucleus_energy(drawn(p, strain), p), 2.0 * p.nucleus.shear_modulus * strain * strain * area,
              1e-2 * p.nucleus.shear_modulus * strain * strain * area);
}

TEST(Nucleus, IsAsStiffWithMoreParticles) {
  Parameters p = with_nucleus();
  const double coarse = nucleus_energy(drawn(p, 0.5), p);
  p.nucleus.particles = 144;
  EXPECT_NEAR(nucleus_energy(drawn(p, 0.5), p) / coarse, 1.0, 0.01);
}

TEST(Nucleus, ReturnsToItsRoundShape) {
  Parameters p = with_nucleus();
  p.nucleus.particles = 36; // for a small system
  CortexState c = drawn(p, 0.5);
  EXPECT_NEAR(aspect_ratio(c), 2.25, 1e-2);
  relax(c, p, 10.0);
  EXPECT_GT(aspect_ratio(c), 1.05) << "it takes longer than its retardation time of 10 s";
  relax(c, p, 190.0);
  EXPECT_NEAR(aspect_ratio(c), 1.0, 1e-3);
  EXPECT_NEAR(area(c), initial_area(lamina(p)), 1e-2);
}

TEST(Nucleus, LosesHardlyAnyAreaUnderPressure) {
  const Parameters p = with_nucleus();
  CortexState c = round_nucleus(p, {0.0, 0.0});
  for (Vec2& x : c.x) x *= 0.95; // as by a pressure of about K/10
  const double lost = 1.0 - area(c) / initial_area(lamina(p));
  const std::vector<Vec2> force = assemble(c, p).force;
  double outward = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) outward += force[i].dot(c.x[i].normalized());
  const double pressure = outward / (perimeter(c) * p.ecm.thickness);
  const double of_chromatin = 2.0 * p.nucleus.shear_modulus * 0.05; // and of the lamina Y 0.05 / R: both small
  EXPECT_NEAR(pressure, p.nucleus.bulk_modulus * lost + of_chromatin + p.nucleus.stretch_stiffness * 0.05 / 5.0,
              0.05 * pressure);
}

TEST(Nucleus, AspectRatioIsThatOfAnEllipseAtAnyAngle) {
  const Parameters p = with_nucleus();
  EXPECT_NEAR(aspect_ratio(round_nucleus(p, {3.0, 4.0})), 1.0, 1e-12);
  EXPECT_NEAR(aspect_ratio(moved(drawn(p, 1.0), {})), 4.0, 1e-9);
}

} // namespace nucleus_test
