#include "contact/viscous.hpp"

#include "ecm/loop/viscosity.hpp"
#include "scene.hpp"
#include "sph/kernel.hpp"

#include <gtest/gtest.h>

using namespace matrigrate;

namespace {

/// @param soft  of the segments; empty: none grows
DragSystem coupling(const Scene& s, std::vector<std::uint8_t> soft = {}) {
  soft.resize(s.c.size(), 0);
  return assemble(s.ecm.size() + s.c.size(),
                  [&](std::span<Vec2>, DragSystem& A) {
                    add_viscous_contact(s.ecm, s.c, soft, s.p, SegmentGrid(s.c, s.reach), s.first(), A);
                  })
      .A;
}

/// Force on the cell while it moves by and the matrix rests.
Vec2 drag_on_cell(const Scene& s, const Vec2& speed, const std::vector<std::uint8_t>& soft = {}) {
  std::vector<Vec2> v(s.ecm.size(), Vec2::Zero());
  v.resize(s.ecm.size() + s.c.size(), speed);
  const std::vector<Vec2> f = drag_force(coupling(s, soft), v);
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = s.ecm.size(); i < f.size(); ++i) sum -= f[i];
  return sum;
}

/// Fluid all around but for particle k, which lies x on the x axis.
Scene alone_at(double x, std::uint32_t k) {
  Scene s;
  std::fill(s.ecm.f.begin(), s.ecm.f.end(), 0.0);
  std::fill(s.ecm.clamped.begin(), s.ecm.clamped.end(), 1);
  s.p.contact.sample_spacing = 10.0; // one sample a segment
  s.ecm.clamped[k] = 0;
  s.ecm.x[k] = {x, 0.0};
  return s;
}

} // namespace

TEST(ViscousContact, DoesNothingWhereCellAndMatrixMoveTogether) {
  const Scene s = touching_scene();
  const DragSystem A = coupling(s);
  const std::vector<Vec2> stir = drag_force(A, stirred(s.positions().size()));
  const std::vector<Vec2> together = drag_force(A, std::vector<Vec2>(stir.size(), Vec2(0.3, -1.0)));
  ASSERT_GT(largest(stir), 1e-3);
  EXPECT_LT(largest(together), 1e-12 * largest(stir));
}

TEST(ViscousContact, ObeysTheThirdLawAndOnlyDissipates) {
  const Scene s = touching_scene();
  const DragSystem A = coupling(s);
  const std::vector<Vec2> v = stirred(s.positions().size());
  const std::vector<Vec2> f = drag_force(A, v);
  EXPECT_LT(net_force(f).norm(), 1e-11 * largest(f));
  EXPECT_GT(power(f, v), 0.0);
  for (const double c : A.links.c) EXPECT_GE(c, 0.0);
}

TEST(ViscousContact, IsThePairDragOfTheirVolumesTimesTheSolidAndAShareOfTheFluid) {
  const std::uint32_t k = 5;
  Scene s = alone_at(9.9, k); // 4.9 um out: few segments in reach, all of them with their outer side
  s.ecm.f[k] = 0.25;
  double pair = 0.0;
  const Kernel kernel(s.p.ecm.smoothing_length);
  for (std::size_t i = 0; i < s.c.size(); ++i) {
    const Vec2 e = s.c.x[s.c.next(i)] - s.c.x[i];
    const double r = (s.c.x[i] + 0.5 * e - s.ecm.x[k]).norm();
    const double shared = std::sqrt(s.ecm.V0 * e.norm() * s.p.ecm.particle_spacing);
    pair += pair_drag(r * r, kernel.W_slope(r), shared, s.p.ecm.viscosity, 1.0, kernel.h());
  }
  ASSERT_GT(pair, 0.0);
  for (const double share : {0.0, 0.1, 1.0}) {
    s.p.contact.body_fluid_share = share;
    EXPECT_NEAR(drag_on_cell(s, {1.0, 0.0}).x(), -(0.25 + 0.75 * share) * pair, 1e-12) << share;
  }
}

TEST(ViscousContact, FluidHoldsTheCellFromOutsideOnly) {
  const std::uint32_t k = 5;
  EXPECT_LT(drag_on_cell(alone_at(6.0, k), {1.0, 0.0}).x(), 0.0);
  EXPECT_EQ(drag_on_cell(alone_at(4.0, k), {1.0, 0.0}).norm(), 0.0);
  Scene solid = alone_at(4.0, k);
  solid.ecm.f[k] = 1.0; // solid that the cortex has just passed holds it
  EXPECT_LT(drag_on_cell(solid, {1.0, 0.0}).x(), 0.0);
}

TEST(ViscousContact, FluidHoldsTheCellLessThanSolid) {
  const Scene held = touching_scene();
  Scene loose = held;
  std::fill(loose.ecm.f.begin(), loose.ecm.f.end(), 0.0);
  const double in_fluid = drag_on_cell(loose, {1.0, 0.0}).x();
  EXPECT_LT(in_fluid, 0.0);
  EXPECT_GT(in_fluid, 0.2 * drag_on_cell(held, {1.0, 0.0}).x());
  loose.p.contact.fluid_share = loose.p.contact.body_fluid_share = 0.0;
  EXPECT_EQ(drag_on_cell(loose, {1.0, 0.0}).norm(), 0.0);
}

TEST(ViscousContact, FluidHoldsGrowingProtrusionsAndTheBodyByTheirOwnShares) {
  Scene s = touching_scene();
  std::fill(s.ecm.f.begin(), s.ecm.f.end(), 0.0);
  const std::vector<std::uint8_t> all(s.c.size(), 1);
  std::vector<std::uint8_t> half = all;
  std::fill_n(half.begin(), s.c.size() / 2, 0);
  std::vector<std::uint8_t> other_half;
  for (const std::uint8_t grows : half) other_half.push_back(grows == 0 ? 1 : 0);
  const auto drag = [&](double of_tips, double of_body, const std::vector<std::uint8_t>& soft) {
    s.p.contact.fluid_share = of_tips;
    s.p.contact.body_fluid_share = of_body;
    return drag_on_cell(s, {1.0, 0.0}, soft).x();
  };
  const double whole = drag(0.2, 0.2, {});
  ASSERT_LT(whole, 0.0);
  EXPECT_DOUBLE_EQ(drag(0.2, 0.2, half), whole) << "one share for both, as before";
  EXPECT_DOUBLE_EQ(drag(0.2, 0.0, all), whole);
  EXPECT_EQ(drag(0.2, 0.0, {}), 0.0) << "a body without drag from fluid";
  EXPECT_EQ(drag(0.0, 0.2, all), 0.0);
  const double of_half = drag(0.2, 0.0, half);
  EXPECT_LT(of_half, 0.0);
  EXPECT_NEAR(of_half + drag(0.2, 0.0, other_half), whole, 1e-12) << "a share of each segment";
  EXPECT_NEAR(drag(0.2, 0.05, half), of_half + 0.25 * (whole - of_half), 1e-12);
}

TEST(ViscousContact, DoesNotDependOnHowFinelyTheSegmentsAreSampled) {
  Scene coarse = touching_scene();
  Scene fine = coarse;
  coarse.p.contact.sample_spacing = 0.8;
  fine.p.contact.sample_spacing = 0.05;
  const double f = drag_on_cell(fine, {0.0, 1.0}).y();
  EXPECT_NEAR(drag_on_cell(coarse, {0.0, 1.0}).y(), f, 0.02 * std::abs(f));
}
