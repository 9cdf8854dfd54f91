#include "cues/sensing.hpp"

#include "cell/geometry.hpp"
#include "protrusion/initiation.hpp"
#include "sph/interpolate.hpp"
#include "sph/kernel.hpp"
#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

using namespace matrigrate;

namespace {

/// A round cell in its hole, whose matrix has what a test gives it.
struct Scene {
  Parameters p;
  EcmState ecm;
  Cell cell;

  Scene() {
    p.ecm.radius = 60.0;
    ecm = disc(p);
    cell.cortex = round_cortex(p.cell);
  }

  /// Factors by a law of initiation.
  std::vector<double> biased(const std::string& law) {
    p.laws.initiation_bias = law;
    return propensity(cell, ecm, p, Laws(p).initiation_bias);
  }

  /// Factor of the particle of the cortex that is nearest to an angle from the x axis.
  double at(const std::vector<double>& factor, double angle) const {
    const Vec2 place = p.cell.radius * Vec2(std::cos(angle), std::sin(angle));
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < cell.cortex.size(); ++i)
      if ((cell.cortex.x[i] - place).norm() < (cell.cortex.x[nearest] - place).norm()) nearest = i;
    return factor[nearest];
  }
};

constexpr double pi = std::numbers::pi;

} // namespace

TEST(Cues, AreOffUntilAsked) {
  Scene s;
  s.ecm.attractant.assign(s.ecm.size(), 1.0);
  for (const double factor : propensity(s.cell, s.ecm, s.p, Law("laws.initiation_bias", {}))) EXPECT_EQ(factor, 1.0);
}

TEST(Occupancy, IsHalfAtTheDissociationConstant) {
  EXPECT_DOUBLE_EQ(occupancy(0.0, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(occupancy(2.0, 2.0), 0.5);
  EXPECT_NEAR(occupancy(2e6, 2.0), 1.0, 1e-5);
}

TEST(Chemotaxis, FollowsTheOccupancyOfReceptors) {
  Scene s;
  const auto c = [](double x) { return 1.0 + x / 50.0; };
  for (const Vec2& X : s.ecm.X) s.ecm.attractant.push_back(std::max(0.0, c(X.x())));
  s.p.cues.half_occupancy = 2.0;
  const std::vector<double> factor = s.biased("exp(5*occupancy)");
  const double R = s.p.cell.radius;
  const double expected = std::exp(5.0 * (occupancy(c(R), 2.0) - occupancy(c(-R), 2.0)));
  EXPECT_NEAR(s.at(factor, 0.0) / s.at(factor, pi), expected, 0.02 * expected);
  EXPECT_NEAR(s.at(factor, pi / 2) / s.at(factor, -pi / 2), 1.0, 0.02);
  EXPECT_NEAR(std::accumulate(factor.begin(), factor.end(), 0.0) / static_cast<double>(factor.size()), 1.0, 1e-12)
      << "a round cell begins as many as without";
}

TEST(Chemotaxis, IsBlindToAUniformField) {
  Scene s;
  s.ecm.attractant.assign(s.ecm.size(), 3.0);
  for (const double a : s.biased("exp(50*occupancy)")) EXPECT_NEAR(a, 1.0, 1e-9);
}

// Of 200 first protrusions with and without attractant, on a cell that is all front.
TEST(Chemotaxis, TurnsFirstProtrusionsTowardsTheSource) {
  Scene s;
  for (const Vec2& X : s.ecm.X) s.ecm.attractant.push_back(std::exp(X.x() / 30.0));
  const std::vector<double> factor = s.biased("exp(8*occupancy)");
  const std::vector<Vec2> n = normals(s.cell.cortex);
  const std::vector<std::uint8_t> front(s.cell.cortex.size(), 1);
  const std::vector<double> rate(front.size(), s.p.protrusion.initiation_rate);
  const auto mean_cosine = [&](std::span<const double> of) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      s.p.run.seed = seed;
      Cell cell = s.cell;
      for (std::uint64_t step = 1; cell.protrusions.empty(); ++step)
        initiate(cell, {step, 5.0 * static_cast<double>(step)}, s.p, 5.0, {front, n, Vec2::Zero(), 1.0, rate, of});
      sum += std::get<Growing>(cell.protrusions.front().phase).direction.x();
    }
    return sum / 200.0;
  };
  double expected = 0.0; // of the hazards themselves
  for (std::size_t i = 0; i < factor.size(); ++i)
    expected += factor[i] * s.cell.cortex.x[i].normalized().x() / static_cast<double>(factor.size());
  EXPECT_GT(expected, 0.3);
  EXPECT_NEAR(mean_cosine(factor), expected, 0.12) << "2.5 standard errors";
  EXPECT_NEAR(mean_cosine({}), 0.0, 0.12);
}

TEST(Haptotaxis, FeelsLigandOnSolidAlone) {
  Scene s;
  for (const Vec2& X : s.ecm.X) s.ecm.ligand.push_back(X.x() > 0.0 ? 1.5 : 0.5);
  std::ranges::fill(s.ecm.f, 1.0);
  const std::vector<double> factor = s.biased("exp(2*ligand)");
  EXPECT_NEAR(s.at(factor, 0.0) / s.at(factor, pi), std::exp(2.0), 0.01 * std::exp(2.0));
  std::ranges::fill(s.ecm.f, 0.0);
  for (const double a : s.biased("exp(2*ligand)")) EXPECT_NEAR(a, 1.0, 1e-12);
}

TEST(Bias, KnowsCurvatureAndTheAngleToThePolarization) {
  Scene s;
  s.cell.polarization = 1.0;
  const std::vector<double> factor = s.biased("1 + cos(angle)");
  EXPECT_NEAR(s.at(factor, 1.0), 2.0, 0.01);
  EXPECT_NEAR(s.at(factor, 1.0 + pi), 0.0, 0.01);
  s.p.laws.initiation_rate = "1e-3*kappa";
  for (const double rate : along_cortex(Laws(s.p).initiation_rate, s.cell, s.ecm, s.p))
    EXPECT_NEAR(rate, 1e-3 / s.p.cell.radius, 1e-6);
  for (const double rate : along_cortex(Law("laws.initiation_rate", {}), s.cell, s.ecm, s.p))
    EXPECT_EQ(rate, s.p.protrusion.initiation_rate) << "of the paper";
}

// What vanishes straight ahead must not keep the first protrusion from beginning.
TEST(Bias, IsTheMeanOverAnglesBeforeThereIsAPolarization) {
  Scene s;
  const auto mean_of = [&](const std::string& law) {
    s.p.laws.initiation_rate = law;
    const std::vector<double> rate = along_cortex(Laws(s.p).initiation_rate, s.cell, s.ecm, s.p);
    return std::accumulate(rate.begin(), rate.end(), 0.0) / static_cast<double>(rate.size());
  };
  EXPECT_NEAR(mean_of("1e-3*min(1, abs(angle))"), 1e-3 * (1.0 - 0.5 / pi), 1e-6) << "of the integral over a turn";
  EXPECT_NEAR(mean_of("1e-3*(angle > 0)"), 0.5e-3, 1e-9);
  EXPECT_NEAR(mean_of("1e-3*kappa*abs(angle)"), 1e-3 / s.p.cell.radius * pi / 2, 1e-7);
  for (const double factor : s.biased("(angle > 0)*1")) EXPECT_NEAR(factor, 1.0, 1e-12);
  s.cell.polarization = 0.0;
  EXPECT_NEAR(s.at(s.biased("(angle > 0)*1"), pi / 2), 2.0, 0.02);
}

TEST(Bias, ThatIsZeroAllAroundIsNone) {
  Scene s;
  s.ecm.ligand.assign(s.ecm.size(), 0.2);
  std::ranges::fill(s.ecm.f, 1.0);
  EXPECT_TRUE(s.biased("ligand > 0.5 ? 1 : 0").empty());
  EXPECT_TRUE(s.biased("0").empty());
  EXPECT_EQ(s.biased("ligand > 0.1 ? 1 : 0").size(), s.cell.cortex.size());
}

TEST(Ligand, IsWhatAdhesionsHoldOnTo) {
  Scene s;
  for (const Vec2& X : s.ecm.X) s.ecm.ligand.push_back(X.x() > 0.0 ? 1.0 : 0.0);
  const Kernel kernel(s.p.ecm.smoothing_length);
  EXPECT_NEAR(solid_weights(s.ecm, kernel, {40.0, 0.0}).support, 1.0, 0.02);
  EXPECT_EQ(solid_weights(s.ecm, kernel, {-40.0, 0.0}).support, 0.0) << "nothing adheres where there is none";
  const PointWeights edge = solid_weights(s.ecm, kernel, {0.0, 40.0});
  for (const std::uint32_t k : edge.index) EXPECT_GT(s.ecm.X[k].x(), 0.0);
}

TEST(Guidance, FollowsTheAxisOfTheFibres) {
  Scene s;
  s.p.fibres.direction_deg = 30.0;
  std::vector<double> factor = s.biased("exp(0.7*alignment)");
  const double along = s.at(factor, pi / 6), against = s.at(factor, pi / 6 + pi),
               across = s.at(factor, pi / 6 + pi / 2);
  EXPECT_NEAR(along / across, std::exp(1.4), 0.01 * std::exp(1.4));
  EXPECT_NEAR(along / against, 1.0, 0.01) << "an axis has no sign";
  s.ecm.fibre_direction.assign(s.ecm.size(), pi / 2);
  factor = s.biased("exp(0.7*alignment)");
  EXPECT_NEAR(s.at(factor, pi / 2) / s.at(factor, 0.0), std::exp(1.4), 0.01 * std::exp(1.4)) << "by the field";
}
