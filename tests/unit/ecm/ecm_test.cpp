#include "body.hpp"
#include "ecm/bonds.hpp"
#include "ecm/degradation.hpp"
#include "ecm/drag_cache.hpp"
#include "ecm/loop/fibres.hpp"
#include "ecm/reference.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace matrigrate;

namespace matrigrate {
namespace {

Parameters uniaxial(Lattice lattice, double direction, double half_angle) {
  Parameters p;
  p.ecm.lattice = lattice;
  p.fibres.arrangement = FibreArrangement::uniaxial;
  p.fibres.direction_deg = direction;
  p.fibres.half_angle_deg = half_angle;
  return p;
}

void expect_directions(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-3);
}

TEST(Bonds, DirectionsOfTheSquareLattice) {
  expect_directions(bond_directions(EcmParameters{}), {0, 26.565, 45, 63.435, 90, 116.565, 135, 153.435});
}

TEST(Bonds, DirectionsOfTheHexagonalLattice) {
  EcmParameters ecm;
  ecm.lattice = Lattice::hexagonal;
  expect_directions(bond_directions(ecm), {0, 30, 60, 90, 120, 150});
}

TEST(Bonds, OnTheEdgeOfTheKernelThereIsNone) {
  EcmParameters ecm;
  ecm.smoothing_length = ecm.particle_spacing; // 2h is two spacings, where the kernel is 0
  expect_directions(bond_directions(ecm), {0, 45, 90, 135});
}

/// As many as a particle in the middle of a disc has in the network that a run computes with.
TEST(Bonds, AreThoseOfTheNetwork) {
  for (const auto& [direction, half_angle] :
       {std::pair{0.0, 30.0}, {13.0, 5.0}, {20.0, 15.0}, {45.0, 30.0}, {0.0, 90.0}})
    for (const Lattice lattice : {Lattice::square, Lattice::hexagonal}) {
      Parameters p = uniaxial(lattice, direction, half_angle);
      p.ecm.radius = 40.0;
      const EcmState ecm = disc(p);
      const FibreNetwork network(ecm, p.ecm, p.fibres, Reference(ecm, p.ecm));
      std::size_t middle = 0;
      for (std::size_t i = 0; i < ecm.size(); ++i)
        if (ecm.X[i].norm() < ecm.X[middle].norm()) middle = i;
      EXPECT_EQ(fibre_bonds(p).count, network.pairs().first[middle + 1] - network.pairs().first[middle])
          << direction << " " << half_angle;
    }
}

TEST(Bonds, TheirMeanDirectionIsThatOfTheFibres) {
  EXPECT_NEAR(*fibre_bonds(uniaxial(Lattice::square, 0, 30)).mean_deg, 0.0, 1e-9);
  EXPECT_NEAR(*fibre_bonds(uniaxial(Lattice::square, 135, 10)).mean_deg, 135.0, 1e-9);
  EXPECT_NEAR(*fibre_bonds(uniaxial(Lattice::square, 20, 10)).mean_deg, 26.565, 1e-3) << "not the one asked for";
  EXPECT_NEAR(*fibre_bonds(uniaxial(Lattice::square, -45, 10)).mean_deg, 135.0, 1e-9);
  Parameters p;
  EXPECT_EQ(fibre_bonds(p).count, 0U);
  p.fibres.arrangement = FibreArrangement::isotropic;
  EXPECT_EQ(fibre_bonds(p).count, 20U);
  EXPECT_FALSE(fibre_bonds(p).mean_deg);
}

TEST(Bonds, FibresThatNoBondMeetsAreAFault) {
  EXPECT_EQ(fault_of_fibres(Parameters{}), "");
  EXPECT_EQ(fault_of_fibres(uniaxial(Lattice::square, 0, 30)), "");
  EXPECT_EQ(fault_of_fibres(uniaxial(Lattice::square, 45, 5)), "");
  EXPECT_NE(fault_of_fibres(uniaxial(Lattice::square, 13, 5)), "");
  EXPECT_NE(fault_of_fibres(uniaxial(Lattice::hexagonal, 45, 14)), "");
}

TEST(Bonds, HexagonalBondsOnTheBoundaryAreAFault) {
  EXPECT_TRUE(fault_of_fibres(uniaxial(Lattice::hexagonal, 0, 30))
                  .ends_with("take a half angle of 29, without them, or 31, with them"));
  EXPECT_NE(fault_of_fibres(uniaxial(Lattice::hexagonal, 60, 30)), "");
  EXPECT_EQ(fault_of_fibres(uniaxial(Lattice::hexagonal, 0, 29)), "");
  EXPECT_EQ(fault_of_fibres(uniaxial(Lattice::hexagonal, 0, 31)), "");
  EXPECT_EQ(fault_of_fibres(uniaxial(Lattice::hexagonal, 10, 30)), "");
}

} // namespace
} // namespace matrigrate

TEST(Degraded, FallsLinearlyAndNeverBelowZero) {
  EXPECT_DOUBLE_EQ(degraded(1.0, 0.2, 0.4), 0.92);
  EXPECT_EQ(degraded(0.05, 0.2, 0.4), 0.0);
  EXPECT_EQ(degraded(0.3, 0.0, 0.4), 0.3);
  double f = 1.0;
  int steps = 0;
  for (; f > 0.0; ++steps) f = degraded(f, 0.2, 0.4); // 5 s at the tip
  EXPECT_NEAR(steps * 0.4, 5.0, 0.41);
}

TEST(Torn, WhatReachesABoundOfDensityBecomesFluid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 20.0, 20.0, 2.0);
  EXPECT_EQ(fluidize_torn(ecm, p), 0U);
  ecm.rho[44] = p.density_min;
  ecm.rho[45] = p.density_max;
  ecm.rho[46] = 1.79;
  ecm.rho[0] = p.density_max; // clamped
  EXPECT_EQ(fluidize_torn(ecm, p), 2U);
  EXPECT_EQ(ecm.f[44], 0.0);
  EXPECT_EQ(ecm.f[45], 0.0);
  EXPECT_EQ(ecm.rho[45], 1.0);
  EXPECT_EQ(ecm.f[46], 1.0);
  EXPECT_EQ(ecm.f[0], 1.0);
  EXPECT_EQ(fluidize_torn(ecm, p), 0U);
}

TEST(Orphans, AFlakeWithoutSupportBecomesFluid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  Reference ref(ecm, p);
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U); // intact, corners included
  const std::size_t flake = 10 * 20 + 10;
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    const double r = (ecm.X[i] - ecm.X[flake]).norm();
    if (r > 0.0 && r < 8.0) ecm.f[i] = 0.0;
  }
  ecm.S[flake](0, 1) = 0.01;
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 1U);
  EXPECT_EQ(ecm.f[flake], 0.0);
  EXPECT_EQ(ecm.S[flake].norm(), 0.0);
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U);
}

TEST(Orphans, AChainUnravelsToItsEnd) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (i / 20 != 10) ecm.f[i] = 0.0; // a single row is left: no support across it
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 20U);
  for (const double f : ecm.f) EXPECT_EQ(f, 0.0);
}

TEST(Orphans, AndTornParticlesAreSeenBeforehand) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  Reference ref(ecm, p);
  EXPECT_FALSE(any_torn_or_orphan(ecm, p, ref));
  EcmState torn = ecm;
  torn.rho[210] = p.density_max;
  EXPECT_TRUE(any_torn_or_orphan(torn, p, ref));
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (const double r = (ecm.X[i] - ecm.X[210]).norm(); r > 0.0 && r < 8.0) ecm.f[i] = 0.0;
  EXPECT_TRUE(any_torn_or_orphan(ecm, p, ref)) << "a flake";
}

TEST(Orphans, ClampedParticlesStaySolid) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  ecm.clamped[0] = 1;
  Reference ref(ecm, p);
  for (std::size_t i = 1; i < ecm.size(); ++i) ecm.f[i] = 0.0;
  EXPECT_EQ(fluidize_orphans(ecm, p, ref), 0U);
  EXPECT_EQ(ecm.f[0], 1.0);
}

namespace {

/// The drag at positions x, computed from nothing.
DragSystem computed(EcmState ecm, const std::vector<Vec2>& x, const EcmParameters& p) {
  ecm.x = x;
  DragSystem A;
  assemble_viscosity(ecm, p, RowPattern(neighbours_within(ecm.x, 8.0, ecm.period_x), ecm.clamped), A, 0.3);
  return A;
}

/// Moves twenty particles in the middle.
void stir(EcmState& ecm) {
  for (std::size_t i = ecm.size() / 2; i < ecm.size() / 2 + 20; ++i) ecm.x[i] += Vec2(0.1, -0.07);
}

} // namespace

TEST(DragCache, HasTheSameBitsWhereAFewRowsOfTheListChange) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  std::size_t mended = 0;
  for (int step = 0; step < 12; ++step) {
    const auto changed = list.update(ecm.x, ecm.period_x);
    if (!changed.empty() && std::ranges::count(changed, 1) < std::ssize(changed)) ++mended;
    cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
    expect_same(kept, computed(ecm, ecm.x, p));
    stir(ecm);
  }
  EXPECT_GE(mended, 3U);
}

TEST(DragCache, MissesNoUpdateOfTheList) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  for (int step = 0; step < 20; ++step) {
    list.update(ecm.x, ecm.period_x);
    if (step % 5 == 0) {
      cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
      expect_same(kept, computed(ecm, ecm.x, p));
    }
    stir(ecm);
  }
  EXPECT_GT(list.updates(), 4U);
}

TEST(DragCache, ComputesRowsAgainThatHaveBeenAddedTo) {
  const EcmParameters p;
  const EcmState ecm = deformed_body(p);
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  list.update(ecm.x, ecm.period_x);
  DragCache cache(ecm, p);
  DragSystem kept;
  cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{50, 51}, {51, 50}}) {
    ASSERT_NE(kept.pairs.find(i, j), nullptr);
    *kept.pairs.find(i, j) += 1.0F;
    kept.diagonal[i] += 1.0;
    kept.touched[i] = 1;
  }
  cache.assemble(ecm, p, list, {}, 0.0, 0.3, kept);
  expect_same(kept, computed(ecm, ecm.x, p));
}

TEST(DragCache, TakesTheDragWhereItWasUntilSomethingMovesBeyondTheLag) {
  const EcmParameters p;
  EcmState ecm = deformed_body(p);
  const std::vector<Vec2> before = ecm.x;
  VerletList list(2.0 * p.smoothing_length, p.verlet_skin);
  DragCache cache(ecm, p);
  DragSystem kept;
  for (Vec2& x : ecm.x) x += Vec2(0.009, 0.0);
  list.update(ecm.x, ecm.period_x);
  cache.assemble(ecm, p, list, before, 0.01, 0.3, kept);
  EXPECT_EQ(cache.x_drag(), before);
  expect_same(kept, computed(ecm, before, p));
  cache.assemble(ecm, p, list, before, 0.008, 0.3, kept);
  EXPECT_EQ(cache.x_drag(), ecm.x);
  expect_same(kept, computed(ecm, ecm.x, p));
}

TEST(DragTiles, AreRefreshedTogetherWhereOneParticleHasMovedFurtherThanTheLag) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 80.0, 40.0, 0.0);
  const DragTiles tiles(ecm.X, p.particle_spacing);
  std::vector<Vec2> x_drag;
  tiles.refresh(ecm.x, 0.01, x_drag, x_drag);
  EXPECT_EQ(x_drag, ecm.x);
  const auto tile_of = [&](std::size_t i) {
    const double width = 8.0 * p.particle_spacing;
    return std::pair(std::floor(ecm.X[i].x() / width), std::floor(ecm.X[i].y() / width));
  };
  const std::vector<Vec2> before = ecm.x;
  const std::size_t far = ecm.size() - 3; // in the last tile
  ASSERT_NE(tile_of(3), tile_of(far));
  for (Vec2& x : ecm.x) x += Vec2(0.009, 0.0);
  ecm.x[3] = before[3] + Vec2(0.0, -0.011);
  tiles.refresh(ecm.x, 0.01, x_drag, x_drag);
  for (std::size_t i = 0; i < ecm.size(); ++i)
    EXPECT_EQ(x_drag[i], tile_of(i) == tile_of(3) ? ecm.x[i] : before[i]) << i;
  tiles.refresh(ecm.x, 0.0, x_drag, x_drag);
  EXPECT_EQ(x_drag, ecm.x);
}

TEST(Reference, SupportInsideALatticeIsNearlyTheIdentity) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    if (ecm.X[i].cwiseAbs().maxCoeff() > 14.0) continue;
    EXPECT_NEAR((ref.B(i) - Mat2::Identity()).norm(), 0.0, 0.05);
    EXPECT_NEAR(ref.B(i)(0, 1), 0.0, 1e-14);
  }
}

TEST(Reference, ABodysOwnEdgeIsNoDamage) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 40.0, 0.0);
  const Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) EXPECT_GE(ref.relative_support(i), 1.0 - 1e-12);
}

TEST(Reference, AnUpdateEqualsAFreshStart) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 30.0, 30.0, 0.0);
  Reference ref(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); i += 3) ecm.f[i] = 0.4;
  ecm.f[100] = 0.0;
  ref.update(ecm);
  const Reference fresh(ecm, p);
  for (std::size_t i = 0; i < ecm.size(); ++i) {
    EXPECT_EQ(ref.B(i), fresh.B(i));
    EXPECT_EQ(ref.relative_support(i), fresh.relative_support(i));
  }
}

TEST(Reference, LostSupportIsSeenAndItsInverseBounded) {
  const EcmParameters p;
  EcmState ecm = rectangle(p, 30.0, 30.0, 0.0);
  const std::size_t flake = 7 * 15 + 7;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (i != flake && i != flake + 1) ecm.f[i] = 0.0; // one partner left: no support across
  const Reference ref(ecm, p);
  EXPECT_LT(ref.relative_support(flake), 0.01);
  EXPECT_LE(ref.B(flake).norm(), 1.5 / p.support_floor);
}

TEST(Reference, AClampGoesOnBeyondItsLastRow) {
  const EcmParameters p;
  const EcmState ecm = rectangle(p, 40.0, 20.0, 5.2);
  const Reference ref(ecm, p);
  std::size_t clamped = 0;
  for (std::size_t i = 0; i < ecm.size(); ++i)
    if (ecm.clamped[i]) {
      ++clamped;
      EXPECT_NEAR((ref.B(i) - ref.B(i)(0, 0) * Mat2::Identity()).norm(), 0.0, 1e-12);
      EXPECT_NEAR(ref.B(i)(0, 0), 1.0, 0.05);
    }
  EXPECT_GT(clamped, 0U);
}
