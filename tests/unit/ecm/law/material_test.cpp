#include "ecm/law/material.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

using namespace matrigrate;

TEST(Moduli, AreThoseOfTable1) {
  const Moduli m = moduli(EcmParameters{});
  EXPECT_NEAR(m.K, 0.2 / 0.3, 1e-15);
  EXPECT_NEAR(m.G, 0.2 / 2.9, 1e-15);
  EXPECT_NEAR(m.longitudinal(), m.K + 4.0 * m.G / 3.0, 1e-15);
}

TEST(JaumannRate, OfASpinTurnsTheStressAndMakesNone) {
  const Mat2 spin = (Mat2() << 0.0, -0.3, 0.3, 0.0).finished();
  EXPECT_EQ(jaumann_rate(Mat2::Zero(), spin, 0.07).norm(), 0.0);
  const Mat2 S = (Mat2() << 0.02, 0.005, 0.005, -0.01).finished();
  const Mat2 rate = jaumann_rate(S, spin, 0.07);
  EXPECT_NEAR(contraction(rate, S), 0.0, 1e-18); // |S| is kept
  EXPECT_NEAR(rate.trace(), 0.0, 1e-18);
  const double dt = 1e-6;
  const Mat2 R = Eigen::Rotation2Dd(0.3 * dt).toRotationMatrix();
  EXPECT_NEAR(((R * S * R.transpose() - S) / dt - rate).norm(), 0.0, 1e-8);
}

TEST(JaumannRate, OfShearAndStretchIsHookesLaw) {
  const Mat2 shear = (Mat2() << 0.0, 1.0, 0.0, 0.0).finished();
  EXPECT_DOUBLE_EQ(jaumann_rate(Mat2::Zero(), shear, 0.07)(0, 1), 0.07); // G for a unit shear rate
  const Mat2 stretch = (Mat2() << 1.0, 0.0, 0.0, 0.0).finished();
  const Mat2 rate = jaumann_rate(Mat2::Zero(), stretch, 0.07);
  EXPECT_DOUBLE_EQ(rate(0, 0), 2.0 * 0.07 * 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(rate(1, 1), -2.0 * 0.07 / 3.0);
}

TEST(JaumannRate, IsObjective) {
  const Mat2 S = (Mat2() << 0.02, 0.005, 0.005, -0.01).finished();
  const Mat2 L = (Mat2() << 0.1, 0.4, -0.2, 0.05).finished();
  const Mat2 R = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  const Mat2 turned = jaumann_rate(R * S * R.transpose(), R * L * R.transpose(), 0.07);
  EXPECT_NEAR((turned - R * jaumann_rate(S, L, 0.07) * R.transpose()).norm(), 0.0, 1e-16);
}

TEST(Density, FollowsTheContinuityEquation) {
  EXPECT_DOUBLE_EQ(density_rate(1.2, Mat2::Identity()), -2.4);
  EXPECT_DOUBLE_EQ(pressure(1.1, 0.5), 0.5 * (1.1 - 1.0));
}

TEST(PiolaKirchhoff, IsTheStressTimesTheCofactor) {
  const Mat2 sigma = (Mat2() << 0.02, 0.005, 0.004, -0.01).finished();
  const Mat2 F = (Mat2() << 1.1, 0.2, -0.1, 0.9).finished();
  EXPECT_NEAR((piola_kirchhoff(sigma, F) - F.determinant() * sigma * F.inverse().transpose()).norm(), 0.0, 1e-16);
}

TEST(VelocityGradient, IsTheRateOverTheDeformation) {
  const Mat2 rate = (Mat2() << 0.1, 0.4, -0.2, 0.05).finished();
  const Mat2 F = (Mat2() << 1.1, 0.2, -0.1, 0.9).finished();
  EXPECT_NEAR((velocity_gradient(rate, F) * F - rate).norm(), 0.0, 1e-15);
}

TEST(VonMises, OfPureShearIsRootThreeTimesIt) {
  const Mat2 S = (Mat2() << 0.0, 0.03, 0.03, 0.0).finished();
  EXPECT_NEAR(von_mises(S), std::sqrt(3.0) * 0.03, 1e-16);
  const Mat2 uniaxial = (Mat2() << 2.0 / 3.0, 0.0, 0.0, -1.0 / 3.0).finished(); // of a unit stress along x
  EXPECT_NEAR(von_mises(uniaxial), 1.0, 1e-15);
}
