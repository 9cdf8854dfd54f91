#include "cues/diffusion.hpp"

#include "state/initial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace matrigrate;

namespace {

struct Disc {
  Parameters p;
  EcmState ecm;

  explicit Disc(double radius, Lattice lattice = Lattice::square) {
    p.ecm.radius = radius;
    p.ecm.cell_hole = false;
    p.ecm.lattice = lattice;
    ecm = disc(p);
    ecm.attractant.assign(ecm.size(), 0.0);
  }

  double total() const { return std::accumulate(ecm.attractant.begin(), ecm.attractant.end(), 0.0); }
  double at(const Vec2& X) const {
    const auto nearest = std::ranges::min_element(ecm.X, {}, [&](const Vec2& x) { return (x - X).squaredNorm(); });
    return ecm.attractant[static_cast<std::size_t>(nearest - ecm.X.begin())];
  }
};

class Lattices : public testing::TestWithParam<Lattice> {};

} // namespace

// A disc whose rim is held: c = I_0(r sqrt(k/D)) up to a factor, which the ratio of two places does not have.
TEST_P(Lattices, SteadyStateOfDecayIsABesselFunction) {
  Disc d(60.0, GetParam());
  for (std::size_t i = 0; i < d.ecm.size(); ++i) d.ecm.attractant[i] = d.ecm.clamped[i] ? 1.0 : 0.0;
  Diffusion diffusion(d.ecm, d.p.ecm);
  const double D = 10.0;
  const double k = D / (15.0 * 15.0); // decays over 15 um
  for (int n = 0; n < 5; ++n) diffusion.advance(d.ecm, D, std::vector<double>(d.ecm.size(), k), 1e6);
  for (const double r : {0.0, 10.0, 20.0, 30.0})
    EXPECT_NEAR(d.at({r, 0.0}) / d.at({40.0, 0.0}),
                std::cyl_bessel_i(0.0, r / 15.0) / std::cyl_bessel_i(0.0, 40.0 / 15.0), 0.004)
        << r;
}

// In free space a Gaussian stays one, and its variance grows by 2 D t.
TEST_P(Lattices, AGaussianSpreads) {
  Disc d(100.0, GetParam());
  const double variance = 15.0 * 15.0;
  for (std::size_t i = 0; i < d.ecm.size(); ++i)
    d.ecm.attractant[i] = std::exp(-0.5 * d.ecm.X[i].squaredNorm() / variance);
  const double before = d.total();
  Diffusion diffusion(d.ecm, d.p.ecm);
  const double D = 10.0;
  const double dt = 0.1;
  const std::vector<double> none(d.ecm.size(), 0.0);
  for (int n = 0; n < 100; ++n) diffusion.advance(d.ecm, D, none, dt);
  const double later = variance + 2.0 * D * 10.0;
  EXPECT_NEAR(d.total() / before, 1.0, 1e-4) << "nothing is lost but at the far rim";
  for (const double r : {0.0, 10.0, 20.0, 30.0})
    EXPECT_NEAR(d.at({r, 0.0}), variance / later * std::exp(-0.5 * r * r / later), 0.003) << r;
}

INSTANTIATE_TEST_SUITE_P(Diffusion, Lattices, testing::Values(Lattice::square, Lattice::hexagonal));

TEST(Diffusion, NothingPassesIntoAnObstacle) {
  Disc d(60.0);
  d.ecm.obstacle.assign(d.ecm.size(), 0);
  for (std::size_t i = 0; i < d.ecm.size(); ++i) {
    const double r = d.ecm.X[i].norm();
    if (r > 15.0 && r < 20.0) d.ecm.obstacle[i] = d.ecm.clamped[i] = 1;
    if (r <= 15.0) d.ecm.attractant[i] = r < 6.0 ? 1.0 : 0.0;
  }
  const double before = d.total();
  Diffusion diffusion(d.ecm, d.p.ecm);
  for (int n = 0; n < 50; ++n) diffusion.advance(d.ecm, 10.0, std::vector<double>(d.ecm.size(), 0.0), 10.0);
  EXPECT_NEAR(d.total() / before, 1.0, 1e-7);
  EXPECT_NEAR(d.at({12.0, 0.0}) / d.at({0.0, 0.0}), 1.0, 1e-3) << "it has evened out inside";
  EXPECT_EQ(d.at({30.0, 0.0}), 0.0);
}

TEST(Diffusion, ReleaseAndDecayBalance) {
  Disc d(40.0);
  d.ecm.attractant_source.assign(d.ecm.size(), 0.02);
  for (std::size_t i = 0; i < d.ecm.size(); ++i) d.ecm.attractant[i] = d.ecm.clamped[i] ? 2.0 : 0.0;
  Diffusion diffusion(d.ecm, d.p.ecm);
  for (int n = 0; n < 20; ++n) diffusion.advance(d.ecm, 10.0, std::vector<double>(d.ecm.size(), 0.01), 1e4);
  for (const double c : d.ecm.attractant) EXPECT_NEAR(c, 2.0, 1e-8) << "source over decay";
}

TEST(AttractantLoss, IsDecayEverywhereAndUptakeInsideCells) {
  State s;
  Parameters p;
  p.ecm.radius = 60.0;
  p.cues.decay = 0.01;
  p.cues.uptake = 0.5;
  s.ecm = disc(p);
  s.cells.emplace_back().cortex = round_cortex(p.cell);
  const std::vector<double> loss = attractant_loss(s, p.cues);
  for (std::size_t i = 0; i < s.ecm.size(); ++i) {
    const double r = s.ecm.x[i].norm();
    if (std::abs(r - p.cell.radius) < 0.1) continue;
    EXPECT_DOUBLE_EQ(loss[i], r < p.cell.radius ? 0.51 : 0.01) << r;
  }
}
