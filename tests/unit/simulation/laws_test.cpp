#include "parameters/laws/law.hpp"

#include "ecm/law/fibres.hpp"
#include "parameters/read.hpp"
#include "simulation/start_rules.hpp"

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
    compare("growth_force", p,
            [&](const auto& at) { return p.protrusion.number > 0 ? 1.0 / std::max(1.0, at[0]) : 1.0; });
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
