#include "ecm/bonds.hpp"

#include "ecm/loop/fibres.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

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
