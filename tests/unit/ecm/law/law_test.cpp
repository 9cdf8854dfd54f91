#include "base/vector.hpp"
#include "ecm/law/fibre_table.hpp"
#include "ecm/law/material.hpp"
#include "ecm/law/viscosity.hpp"
#include "pack.hpp"
#include "parameters/read.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace matrigrate;

namespace {

/// Eq. 5 by another formula, so that it is tabulated.
const std::vector<std::string> paper_in_other_words{
    "laws.fibre_stiffness=eps < 0 ? 0 : eps <= eps_s ? 1 : 1*exp((eps - eps_s)/d_s)"};

} // namespace

// The error of the table, of the law's largest value and of the value itself.
TEST(FibreTable, IsThePapersLawToNineDigits) {
  for (const double d_s : {0.033, 0.01, 0.2}) {
    Parameters p = apply_overrides({}, paper_in_other_words);
    p.fibres.stiffening_strain = d_s;
    const auto table = fibre_table(p);
    ASSERT_NE(table, nullptr);
    const FibreLaw law{p.fibres, table.get()};
    const FibreLaw paper{p.fibres, nullptr};
    EXPECT_LT(table->size(), 6000U);
    for (double strain = -0.49; strain < 0.99; strain += 0.000373) {
      const double T = paper.tension(strain);
      EXPECT_NEAR(law.tension(strain), T, 1e-9 * T + 1e-15) << strain;
      EXPECT_NEAR(law.energy(strain), paper.energy(strain), 1e-9 * paper.energy(strain) + 1e-15) << strain;
      const FibreLaw::Pull pull = law.pull(strain), expected = paper.pull(strain);
      EXPECT_NEAR(pull.tension, T, 1e-9 * T + 1e-15) << strain;
      const double least = expected.stiffens ? expected.excess : 0.0; // where it does not stiffen, none is taken
      EXPECT_NEAR(std::max(0.0, pull.excess), least, 1e-9 * fibre_stiffness(strain, p.fibres) + 1e-12) << strain;
    }
    EXPECT_FALSE(law.pushes());
    EXPECT_NEAR(table->at_rest(), 1.0, 1e-12);
  }
}

TEST(FibreTable, IsNotThereForThePapersLaw) { EXPECT_EQ(fibre_table({}), nullptr); }

TEST(FibreTable, IntegratesJumpsAndCompression) {
  const FibreTable table([](double eps) { return eps < -0.1 ? 0.25 : eps < 0.1 ? 1.0 : 3.0; }, -0.5, 1.0);
  EXPECT_TRUE(table.pushes());
  EXPECT_NEAR(table.tension(0.3), 0.1 + 0.6, 1e-11);
  EXPECT_NEAR(table.tension(-0.3), -0.1 - 0.05, 1e-11);
  EXPECT_NEAR(table.energy(0.3), 0.005 + 0.02 + 0.5 * 3.0 * 0.04, 1e-11);
  EXPECT_NEAR(table.energy(-0.3), 0.005 + 0.02 + 0.5 * 0.25 * 0.04, 1e-11);
  EXPECT_EQ(table.tension(0.0), 0.0);
  EXPECT_EQ(table.energy(0.0), 0.0);
}

TEST(FibreTable, IsTheDerivativeOfItsIntegrals) {
  const FibreTable table([](double eps) { return 0.5 + std::sin(20.0 * eps) * std::sin(20.0 * eps); }, -0.5, 1.0);
  constexpr double h = 1e-5;
  for (const double strain : {-0.4, -0.2, -1e-3, 0.0, 1e-3, 0.1, 0.33, 0.7, 0.95}) {
    EXPECT_NEAR((table.tension(strain + h) - table.tension(strain - h)) / (2 * h), table.stiffness(strain), 3e-8);
    EXPECT_NEAR((table.energy(strain + h) - table.energy(strain - h)) / (2 * h), table.tension(strain), 1e-9);
  }
}

TEST(FibreTable, GoesOnWithTheStiffnessOfItsEnds) {
  const FibreTable table([](double eps) { return 1.0 + eps; }, -0.5, 1.0);
  EXPECT_NEAR(table.tension(1.5), 1.5 + 2.0 * 0.5, 1e-12);
  EXPECT_NEAR(table.energy(1.5), 0.5 + 1.0 / 6.0 + 0.5 * 1.5 + 0.5 * 2.0 * 0.25, 1e-12);
  EXPECT_NEAR(table.tension(-0.8), -0.375 - 0.5 * 0.3, 1e-12);
  EXPECT_TRUE(std::isfinite(table.tension(1e6)));
}

// A few points would miss these; what is narrow is found where its ends are told.
TEST(FibreTable, SeesWindowsAndBumps) {
  const auto window = [](double low, double high) {
    return [=](double eps) { return eps > low && eps < high ? 21.0 : 1.0; };
  };
  const auto bump = [](double eps) { return 1.0 + 20.0 * std::exp(-std::pow((eps - 0.05) / 0.005, 2)); };
  const FibreTable wide(window(0.02, 0.06), -0.5, 1.0), smooth(bump, -0.5, 1.0);
  const std::vector<double> ends{0.031, 0.0312};
  const FibreTable narrow(window(0.031, 0.0312), -0.5, 1.0, ends);
  for (int k = 0; k <= 15000; ++k) {
    const double eps = -0.5 + 1e-4 * k + 0.33e-4;
    EXPECT_NEAR(wide.stiffness(eps), window(0.02, 0.06)(eps), 1e-9) << eps;
    EXPECT_NEAR(smooth.stiffness(eps), bump(eps), 1e-9) << eps;
    EXPECT_NEAR(narrow.stiffness(eps), window(0.031, 0.0312)(eps), 1e-9) << eps;
  }
  EXPECT_TRUE(FibreTable(window(-0.2, -0.19), -0.5, 1.0).pushes());
  const std::vector<double> close{5e-324, -5e-324, 0.1, 0.1 + 1e-16, 1.0, -0.5};
  const FibreTable one([](double) { return 1.0; }, -0.5, 1.0, close);
  for (const double eps : {0.0, 5e-324, 0.1, 1.0, -0.5}) EXPECT_NEAR(one.tension(eps), eps, 1e-12) << eps;
}

TEST(FibreTable, RefusesWhatVariesTooQuickly) {
  EXPECT_THROW(FibreTable([](double eps) { return 1.0 + std::sin(1e7 * eps); }, -0.5, 1.0), std::invalid_argument);
}

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

// Each law gives a pack the bits that it gives each of its numbers.

namespace {

constexpr std::size_t lanes = 8;

/// Eight numbers around `middle` that share no pattern.
Eight around(double middle, double width, double phase) {
  Eight a;
  for (std::size_t l = 0; l < lanes; ++l)
    a.set(l, middle + width * std::sin(12.9898 * (static_cast<double>(l) + phase)));
  return a;
}

TensorOf<Eight> tensor(double middle, double width, double phase) {
  return {around(middle, width, phase), around(0.0, width, phase + 0.1), around(0.0, width, phase + 0.2),
          around(middle, width, phase + 0.3)};
}

Tensor lane(const TensorOf<Eight>& A, std::size_t l) { return {A.xx[l], A.xy[l], A.yx[l], A.yy[l]}; }

void expect_same(const TensorOf<Eight>& pack, std::size_t l, const Tensor& number) {
  EXPECT_EQ(pack.xx[l], number.xx);
  EXPECT_EQ(pack.xy[l], number.xy);
  EXPECT_EQ(pack.yx[l], number.yx);
  EXPECT_EQ(pack.yy[l], number.yy);
}

const Eight rho = around(1.0, 0.2, 0.0);
const TensorOf<Eight> S = tensor(0.0, 0.03, 0.4);
const TensorOf<Eight> F = tensor(1.0, 0.2, 0.8);
const TensorOf<Eight> L = tensor(0.0, 0.5, 1.2);

} // namespace

TEST(PackOfMaterial, HasTheBitsOfEachNumber) {
  const double K = 0.7, G = 0.07, dt = 0.4;
  const auto rate = jaumann_rate(S, L, G);
  const auto sigma = cauchy_stress(rho, S, K);
  const auto P = piola_kirchhoff(sigma, F);
  const auto gradient = velocity_gradient(L, F);
  const auto after = advanced({rho, S}, L, G, dt, 0.95, 1.1);
  for (std::size_t l = 0; l < lanes; ++l) {
    EXPECT_EQ(pressure(rho, K)[l], pressure(rho[l], K));
    EXPECT_EQ(density_rate(rho, L)[l], density_rate(rho[l], lane(L, l)));
    expect_same(rate, l, jaumann_rate(lane(S, l), lane(L, l), G));
    expect_same(sigma, l, cauchy_stress(rho[l], lane(S, l), K));
    expect_same(P, l, piola_kirchhoff(lane(sigma, l), lane(F, l)));
    expect_same(gradient, l, velocity_gradient(lane(L, l), lane(F, l)));
    const SolidStateOf<double> number = advanced({rho[l], lane(S, l)}, lane(L, l), G, dt, 0.95, 1.1);
    EXPECT_EQ(after.rho[l], number.rho);
    expect_same(after.S, l, number.S);
  }
}

TEST(PackOfFluid, HasTheBitsOfEachNumber) {
  const Eight f = around(0.5, 0.5, 0.7);
  const Eight p = fluid_pressure(f, rho, 0.7);
  for (std::size_t l = 0; l < lanes; ++l) EXPECT_EQ(p[l], fluid_pressure(f[l], rho[l], 0.7));
}

TEST(PackOfDrag, HasTheBitsOfEachNumber) {
  const EcmParameters p;
  const Kernel kernel(p.smoothing_length);
  const PairDrag<Eight> of_pack(p, kernel, 4.0);
  const PairDrag<double> of_number(p, kernel, 4.0);
  const Eight r = around(3.0, 3.0, 0.0); // some beyond the support of 5.2 um
  const Eight G = of_pack(r, r * r);
  for (std::size_t l = 0; l < lanes; ++l) EXPECT_EQ(G[l], of_number(r[l], r[l] * r[l]));
}

TEST(PairDrag, IsThatOfEquation2) {
  const double h = 2.6;
  const Kernel kernel(h);
  const Vec2 x_ij(2.0, 1.0);
  const double r = x_ij.norm();
  const Vec2 grad_W = kernel.W_slope(r) * x_ij;
  EXPECT_DOUBLE_EQ(pair_drag(r * r, kernel.W_slope(r), 4.0, 1.5, 0.7, h),
                   0.7 * 4.0 * 4.0 * (1.5 + 1.5) * (-x_ij.dot(grad_W)) / (r * r + 0.01 * h * h));
  EXPECT_EQ(pair_drag(36.0, kernel.W_slope(6.0), 4.0, 1.0, 1.0, h), 0.0);
}

TEST(PairDrag, OfEqualParticlesIsTheSame) {
  const EcmParameters p;
  const Kernel kernel(p.smoothing_length);
  const PairDrag<double> in_double(p, kernel, 4.0);
  const PairDrag<float> in_float(p, kernel, 4.0);
  for (double r = 0.1; r < 6.0; r += 0.1) {
    const double G = pair_drag(r * r, kernel.W_slope(r), 4.0, p.viscosity, p.thickness, p.smoothing_length);
    EXPECT_NEAR(in_double(r, r * r), G, 1e-13 * in_double.G_0) << r;
    EXPECT_NEAR(static_cast<double>(in_float(static_cast<float>(r), static_cast<float>(r * r))), G,
                1e-6 * in_double.G_0)
        << r;
  }
}
