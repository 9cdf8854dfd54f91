#include "base/parallel.hpp"
#include "cell/geometry.hpp"
#include "gel.hpp"
#include "parameters/read.hpp"
#include "simulation/advance.hpp"
#include "simulation/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace matrigrate;

namespace {

/// A cell whose protrusions live fast, among fibres, so that a minute shows every law.
Parameters under(const std::vector<std::string>& laws = {}) {
  Parameters p;
  p.ecm.radius = 60.0;
  p.fibres.arrangement = FibreArrangement::isotropic;
  p.protrusion.initiation_rate = 2e-3;
  p.protrusion.growth_time = 20.0;
  p.protrusion.finishing_time = 10.0;
  p.adhesion.maturation_time = 10.0;
  p.adhesion.r_off_min = 0.02;
  p.solver.tolerance = 1e-8;
  return apply_overrides(p, laws);
}

State migrated_under(const Parameters& p, int steps = 150, int fresh_workspace_every = 1000) {
  State s = initial_state(p);
  auto w = std::make_unique<Workspace>(s, p);
  for (int k = 1; k <= steps; ++k) {
    advance(s, p, p.run.time_step, *w);
    if (k % fresh_workspace_every == 0) w = std::make_unique<Workspace>(s, p);
  }
  return s;
}

double furthest_apart(const State& a, const State& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.cells[0].cortex.size(); ++i)
    most = std::max(most, (a.cells[0].cortex.x[i] - b.cells[0].cortex.x[i]).norm());
  return most;
}

} // namespace

// Laws that are one number each: a formula of the same number gives the same bits.
TEST(Laws, OfTheSameNumbersGiveTheSameBits) {
  const State plain = migrated_under(under());
  ASSERT_GE(plain.cells[0].initiated, 2U);
  EXPECT_TRUE(same_bits(plain, migrated_under(under({"laws.initiation_rate=1*r_prot", "laws.polarization_rate=1*r_pol",
                                                     "laws.growth_force=n_prot > 0 && A > 1 ? 1/A : 1 + 0*l*t",
                                                     "laws.degradation_tip=1*r_degr_tip",
                                                     "laws.degradation_protrusion=p <= p_th_degr ? 0 : r_degr_prot",
                                                     "laws.degradation_body=p <= p_th_degr ? 0 : r_degr_body"}))));
}

// Laws with exponentials, and the table of the fibres: the same up to rounding.
TEST(Laws, InOtherWordsDifferByRounding) {
  const State plain = migrated_under(under());
  const State s = migrated_under(
      under({"laws.fibre_stiffness=eps > eps_s ? exp((eps - eps_s)/d_s) : eps < 0 ? 0 : 1",
             "laws.curvature_factor=exp(-0.99999999999999*((kappa - kappa_0)/kappa_w)^2)",
             "laws.disassembly_rate=r_off_0*exp(-zeta_diss*F/f_mat) + r_off_min", "laws.initiation_bias=2"}));
  EXPECT_EQ(s.cells[0].initiated, plain.cells[0].initiated);
  EXPECT_EQ(s.cells[0].ended.size(), plain.cells[0].ended.size());
  EXPECT_LT(furthest_apart(s, plain), 1e-6);
  EXPECT_GT(furthest_apart(s, plain), 0.0) << "the formulas were taken";
}

TEST(Laws, GiveTheSameBitsForAnyNumberOfThreadsAndAfterAnyBreak) {
  const Parameters p =
      under({"laws.fibre_stiffness=eps < 0 ? 0.1*exp(eps/0.02) : 1 + 20*eps",
             "laws.curvature_factor=max(0, 1 - abs(kappa - kappa_0)/kappa_w)",
             "laws.disassembly_rate=0.02*exp(-F/0.1) + 0.001*exp(F/0.3)", "laws.initiation_bias=exp(-5*max(0, kappa))",
             "laws.growth_force=max(0, 1 - l/15 - max(0, speed)/0.5)", "laws.degradation_body=r_degr_body*f*f_degr",
             "laws.contraction=f_mat*f_curv*F_am*max(0, 1 - max(0, speed)/0.2)*exp(-t_mat/600)*density",
             "laws.maturation_force=0.05*F_am*(steps + 1)*(1 + stiffness/E)", "laws.maturation=min(1, 0.2*steps)",
             "laws.adhesion_stiffness=k_ad*(1 + stretch)*(1 + pressure/1000)"});
  const State whole = migrated_under(p, 100);
  {
    const ThreadLimit limit(4);
    EXPECT_TRUE(same_bits(whole, migrated_under(p, 100)));
  }
  EXPECT_TRUE(same_bits(whole, migrated_under(p, 100, 30)));
}

TEST(Laws, OfInitiation) {
  EXPECT_EQ(migrated_under(under({"laws.initiation_rate=0"})).cells[0].initiated, 0U);
  EXPECT_EQ(migrated_under(under({"laws.initiation_bias=0"})).cells[0].initiated,
            migrated_under(under({})).cells[0].initiated)
      << "a bias of 0 all along the cortex is none";
  const State s = migrated_under(under({"laws.initiation_rate=abs(angle) < 0.5 ? 0.01 : 0"}));
  ASSERT_GE(s.cells[0].initiated, 1U);
}

TEST(Laws, OfGrowth) {
  const auto longest = [](const State& s) {
    double most = 0.0;
    for (const Vec2& x : s.cells[0].cortex.x) most = std::max(most, x.norm());
    return most;
  };
  const double plain = longest(migrated_under(under(), 60));
  const double stalled = longest(migrated_under(under({"laws.growth_force=max(0, 1 - l/8)"}), 60));
  const double none = longest(migrated_under(under({"laws.growth_force=0"}), 60));
  EXPECT_LT(stalled, plain - 0.5);
  EXPECT_LT(none, stalled);
}

TEST(Laws, OfDisassembly) {
  const State kept = migrated_under(under({"laws.disassembly_rate=0"}), 300);
  EXPECT_TRUE(std::ranges::none_of(kept.cells[0].ended,
                                   [](const ProtrusionRecord& r) { return r.cause == EndCause::disassembly; }));
  const State brief = migrated_under(under({"laws.disassembly_rate=t > 2 ? 10 : 0"}), 300);
  ASSERT_FALSE(brief.cells[0].ended.empty());
  for (const ProtrusionRecord& r : brief.cells[0].ended) {
    if (r.cause != EndCause::disassembly) continue;
    EXPECT_NEAR(r.t_disassembly - r.t_mature, 2.5, 0.9);
  }
}

TEST(Laws, OfContraction) {
  const auto outline = [](const State& s) { return area(s.cells[0].cortex); };
  const double plain = outline(migrated_under(under({"laws.initiation_rate=0"}), 60));
  EXPECT_GT(outline(migrated_under(under({"laws.initiation_rate=0", "laws.curvature_factor=0"}), 60)), plain + 0.1);
}

TEST(Laws, OfMaturation) {
  const auto f_mat = [](const State& s) {
    double most = 0.0;
    for (const ProtrusionRecord& r : s.cells[0].ended) most = std::max(most, std::isnan(r.f_mat) ? 0.0 : r.f_mat);
    return most;
  };
  const auto with = [&](const std::string& law) {
    return f_mat(migrated_under(under({"laws.disassembly_rate=1", law}), 200));
  };
  const double plain = with("laws.maturation=min(1, 0.1*steps)");
  ASSERT_GT(plain, 0.05);
  EXPECT_DOUBLE_EQ(with("laws.maturation=min(1, 0.2*steps)"), 2.0 * plain);
  EXPECT_EQ(with("laws.maturation_force=100"), 0.05) << "no step is done: that of the body";
}

TEST(Laws, OfContractionOfAStrand) {
  const auto outline = [](const State& s) { return area(s.cells[0].cortex); };
  const double plain = outline(migrated_under(under({"laws.initiation_rate=0"}), 60));
  EXPECT_GT(outline(migrated_under(under({"laws.initiation_rate=0", "laws.contraction=0"}), 60)), plain + 0.1);
  EXPECT_LT(outline(migrated_under(under({"laws.initiation_rate=0", "laws.contraction=2*f_mat*f_curv*F_am"}), 60)),
            plain - 0.1);
  EXPECT_EQ(outline(migrated_under(
                under({"laws.initiation_rate=0", "laws.contraction=time < 1e6 ? f_mat*f_curv*F_am : 0"}), 60)),
            plain)
      << "the same values are the same bits";
}

TEST(Laws, OfTheStiffnessOfAdhesions) {
  const auto most = [](const State& s) {
    double force = 0.0;
    for (const ProtrusionRecord& r : s.cells[0].ended) force = std::max(force, std::isnan(r.force) ? 0.0 : r.force);
    return force;
  };
  EXPECT_LT(most(migrated_under(under({"laws.adhesion_stiffness=0.01*k_ad"}), 200)),
            0.8 * most(migrated_under(under(), 200)));
}

TEST(Laws, OfTimeAndPlace) {
  EXPECT_EQ(migrated_under(under({"laws.initiation_rate=time < 1000 ? 0 : r_prot"})).cells[0].initiated, 0U);
  const State right = migrated_under(under({"laws.initiation_rate=x > 0 ? r_prot : 0"}), 300);
  ASSERT_GE(right.cells[0].initiated, 1U);
  for (const Protrusion& protrusion : right.cells[0].protrusions)
    EXPECT_GT(right.cells[0].cortex.x[protrusion.centre].x(), -3.0);
}

TEST(Laws, OfDegradation) {
  const auto left = [](const State& s) {
    double sum = 0.0;
    for (const double f : s.ecm.f) sum += f;
    return sum;
  };
  const double plain = left(migrated_under(under()));
  EXPECT_GT(left(migrated_under(
                under({"laws.degradation_tip=0", "laws.degradation_protrusion=0", "laws.degradation_body=0"}))),
            plain + 1.0);
  EXPECT_GT(left(migrated_under(under({"laws.degradation_tip=0"}))), plain);
}

TEST(Laws, OfPolarization) {
  const std::vector<std::string> still{"laws.disassembly_rate=0", "laws.polarization_rate=0"};
  const State first = migrated_under(under(still), 80);
  const State later = migrated_under(under(still), 200);
  ASSERT_TRUE(first.cells[0].polarization);
  EXPECT_EQ(*first.cells[0].polarization, *later.cells[0].polarization);
  const State turning =
      migrated_under(under({"laws.disassembly_rate=0", "laws.polarization_rate=0.1/(1 + angle)"}), 200);
  EXPECT_NE(*turning.cells[0].polarization, *first.cells[0].polarization);
}
