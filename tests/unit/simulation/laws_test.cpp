#include "parameters/laws/law.hpp"

#include "ecm/law/fibres.hpp"
#include "parameters/read.hpp"
#include "simulation/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// The default laws are the paper's equations.
namespace matrigrate {
namespace {

/// Compares the text of a law with its equation over the whole range of the variables.
void compare(const std::string& key, const Parameters& p,
             const std::function<double(const std::vector<double>&)>& function, int points = 40) {
  const Row& law = *find_row("laws." + key);
  const fields::Expression text = law_formula(law, p, usual_text(law));
  std::vector<double> at(law.arguments.size());
  const std::function<void(std::size_t)> visit = [&](std::size_t k) {
    if (k == at.size()) {
      const double expected = function(at);
      ASSERT_NEAR(text.at(at), expected, 1e-12 * std::abs(expected)) << key << " at " << at.front();
      return;
    }
    for (int i = 0; i <= points; ++i) {
      at[k] = law.arguments[k].low + (law.arguments[k].high - law.arguments[k].low) * i / points;
      visit(k + 1);
    }
  };
  visit(0);
}

/// The defaults, and a set in which everything differs from them.
std::vector<Parameters> sets() {
  const std::vector<std::string> others{"fibres.onset=0.05",
                                        "fibres.stiffening_strain=0.07",
                                        "actomyosin.curvature_optimum=0.1 1/um",
                                        "actomyosin.curvature_width=0.4 1/um",
                                        "actomyosin.force=0.8 nN",
                                        "adhesion.step_threshold=0.9",
                                        "adhesion.maturation_strands=1.5",
                                        "adhesion.stiffness=3 mN/m",
                                        "adhesion.r_off_min=1e-3 1/s",
                                        "adhesion.r_off_0=0.1 1/s",
                                        "adhesion.zeta_diss=80 1/nN",
                                        "protrusion.number=3",
                                        "degradation.threshold=50 Pa",
                                        "degradation.protrusion_rate=0.1 1/s",
                                        "degradation.body_rate=0.2 1/s"};
  return {Parameters{}, apply_overrides({}, others)};
}

TEST(LawsOfThePaper, AreItsEquations) {
  for (const Parameters& p : sets()) {
    compare("fibre_stiffness", p,
            [&](const auto& at) { return fibre_stiffness(at[0], p.fibres) / p.fibres.stiffness; });
    compare("curvature_factor", p, [&](const auto& at) {
      const double q = (at[0] - p.actomyosin.curvature_optimum) / p.actomyosin.curvature_width;
      return std::exp(-q * q);
    });
    compare("disassembly_rate", p, [a = p.adhesion](const auto& at) {
      return a.r_off_min + a.r_off_0 * std::exp(-a.zeta_diss * at[0] / at[1]);
    });
    compare(
        "growth_force", p, [&](const auto& at) { return p.protrusion.number > 0 ? 1.0 / std::max(1.0, at[0]) : 1.0; },
        10);
    compare(
        "contraction", p, [&](const auto& at) { return at[0] * at[1] * p.actomyosin.force; }, 10);
    compare(
        "maturation_force", p,
        [a = p.adhesion, F = p.actomyosin.force](const auto& at) {
          return 0.1 * (at[0] + a.step_threshold) * a.maturation_strands * F;
        },
        10);
    compare("maturation", p, [](const auto& at) { return std::min(1.0, 0.1 * at[0]); });
    compare("adhesion_stiffness", p, [&](const auto&) { return p.adhesion.stiffness; });
    compare(
        "initiation_rate", p, [&](const auto&) { return p.protrusion.initiation_rate; }, 4);
    compare(
        "initiation_bias", p, [](const auto&) { return 1.0; }, 4);
    compare("polarization_rate", p, [&](const auto&) { return p.polarization.rate; });
    compare("degradation_tip", p, [&](const auto&) { return p.degradation.tip_rate; });
    const auto above = [&](double pressure, double rate) {
      return 1e-3 * pressure > p.degradation.threshold ? rate : 0.0;
    };
    compare("degradation_protrusion", p, [&](const auto& at) { return above(at[1], p.degradation.protrusion_rate); });
    compare("degradation_body", p, [&](const auto& at) { return above(at[1], p.degradation.body_rate); });
  }
}

/// The law of a key with another text.
Law changed(const std::string& key, const std::string& text) {
  return {"laws." + key, apply_overrides({}, std::vector{"laws." + key + "=" + text})};
}

TEST(Laws, HaveTheValuesThatAHandComputes) {
  EXPECT_DOUBLE_EQ(changed("contraction", "f_mat*f_curv*F_am*exp(-t_mat/600)")({0.5, 0.8, 0.0, 0.0}, {.t_mat = 600.0}),
                   0.5 * 0.8 * 0.6 * std::exp(-1.0));
  EXPECT_DOUBLE_EQ(
      changed("contraction", "f_mat*F_am*max(0, 1 - speed/0.12) + 0.001*l")({0.5, 1.0, 0.0, 0.03}, {.l = 12.0}),
      0.5 * 0.6 * 0.75 + 0.012);
  EXPECT_DOUBLE_EQ(
      changed("maturation_force", "stiffness > 150 ? 0.02*(steps + 1) : 9")({3.0, 0.1, 50.0}, {.stiffness = 200.0}),
      0.08);
  EXPECT_DOUBLE_EQ(changed("maturation", "steps/(steps + 2)*f_degr")({3.0}, {.f_degr = 0.5}), 0.3);
  EXPECT_DOUBLE_EQ(changed("adhesion_stiffness", "k_ad*(1 + stretch/0.5)")({0.25}), 3.0);
  EXPECT_DOUBLE_EQ(changed("disassembly_rate", "r_off_min*(time > 3600 ? 2 : 1)")({0.1, 0.5, 60.0}, {.time = 4000.0}),
                   2.0 * 2.78e-4);
  EXPECT_DOUBLE_EQ(changed("polarization_rate", "r_pol*(x > y)")({0.3}, {.x = 2.0, .y = 1.0}), 1.1e-3);
}

TEST(Laws, KnowWhichOfThePlaceTheyUse) {
  EXPECT_FALSE(changed("contraction", "f_mat*f_curv*F_am*0.5").uses_place());
  const Law aged = changed("contraction", "f_mat*F_am*exp(-age/600)");
  EXPECT_TRUE(aged.uses_place());
  EXPECT_TRUE(aged.uses("age"));
  EXPECT_FALSE(aged.uses("l"));
  EXPECT_FALSE(aged.uses_matrix());
  EXPECT_TRUE(changed("contraction", "f_mat*F_am*density").uses_matrix());
  EXPECT_EQ(Laws(Parameters{}).contraction.uses_place(), false);
}

TEST(Laws, FallWithASpeedAsFastAsTheirSlope) {
  const Law linear = changed("growth_force", "max(0, 1 - speed/0.1)");
  EXPECT_NEAR(linear.fall(3, {1.0, 10.0, 60.0, 0.05}, {}), 10.0, 1e-5);
  EXPECT_EQ(linear.fall(3, {1.0, 10.0, 60.0, 0.2}, {}), 0.0) << "it has fallen to 0";
  EXPECT_EQ(changed("growth_force", "1 + abs(speed)").fall(3, {1.0, 10.0, 60.0, 0.05}, {}), 0.0) << "it rises";
}

std::string faults_in(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_parameters(text, "f.toml", overrides, start_rules());
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}

TEST(LawRules, TellWhereAValueIsNotAllowed) {
  EXPECT_EQ(faults_in("[laws]\npolarization_rate = \"-r_pol\"\n"),
            "f.toml:2:21: laws.polarization_rate: is -0.0011 1/s at any argument; allowed is >= 0 and <= 1e+06 1/s; "
            "max(0, ...) keeps it from falling below");
  EXPECT_EQ(faults_in("laws.polarization_rate = \"r_pol/2\"\n"), "");
  EXPECT_NE(faults_in("laws.fibre_stiffness = \"1 + sin(1e7*eps)\"\n").find("varies too quickly near eps = "),
            std::string::npos);
  EXPECT_EQ(faults_in("laws.fibre_stiffness = \"1 + sin(\"\n").find("step"), std::string::npos) << "one fault";
}

TEST(LawRules, JudgeALawWithTheParametersAsTheyAre) {
  const std::string law = "laws.curvature_factor = \"kappa_w/0.25\"\n";
  EXPECT_EQ(faults_in(law), "");
  const std::string wider = faults_in(law, {"actomyosin.curvature_width=0.5 1/um", "ecm.viscosity=900 Pa s"});
  EXPECT_TRUE(wider.starts_with("f.toml:1:25: laws.curvature_factor: is 2 at any argument; allowed is")) << wider;
}

TEST(LawRules, AStifferFibreNeedsAShorterStep) {
  const std::string fibres = "[fibres]\narrangement = \"isotropic\"\nstiffness = \"20 kPa\"\n";
  EXPECT_EQ(faults_in(fibres), "");
  EXPECT_NE(faults_in(fibres + "[laws]\nfibre_stiffness = \"eps < 0 ? 0 : 10\"\n").find("a step of"),
            std::string::npos);
}

} // namespace
} // namespace matrigrate
