#include "ecm/law/fibre_table.hpp"

#include "parameters/read.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

using namespace matrigrate;

namespace {

/// Eq. 5 in other words, so that it is tabulated.
const std::vector<std::string> paper_in_other_words{
    "laws.fibre_stiffness=eps < 0 ? 0 : (eps <= eps_s ? 1 : exp((eps - eps_s)/d_s))"};

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
