#include "parameters/laws/laws.hpp"

#include "cell/actomyosin.hpp"
#include "contact/degrade.hpp"
#include "ecm/law/fibres.hpp"
#include "parameters/laws/law_values.hpp"
#include "parameters/read.hpp"
#include "protrusion/adhesion.hpp"
#include "protrusion/growth.hpp"
#include "simulation/start_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// The texts of the paper's laws are the functions that run.
namespace matrigrate {
namespace {

/// Compares the text of a law with its function over the whole range of the variables.
void compare(const std::string& key, const Parameters& p,
             const std::function<double(const std::vector<double>&)>& function) {
  const Row& law = *find_row("laws." + key);
  const fields::Expression text = law_formula(law, p, usual_text(law));
  const auto variables = law_variables(law);
  constexpr int points = 40;
  std::vector<double> at(variables.size());
  const std::function<void(std::size_t)> visit = [&](std::size_t k) {
    if (k == at.size()) {
      const double expected = function(at);
      ASSERT_NEAR(text.at(at), expected, 1e-12 * std::abs(expected)) << key << " at " << at.front();
      return;
    }
    for (int i = 0; i <= points; ++i) {
      at[k] = variables[k].low + (variables[k].high - variables[k].low) * i / points;
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

// Kept results were computed by the formula.
TEST(LawsOfThePaper, CurvatureHasTheBitsOfItsFormula) {
  const Parameters p;
  const Row& law = *find_row("laws.curvature_factor");
  const fields::Expression text = law_formula(law, p, usual_text(law));
  for (int i = 0; i <= 100000; ++i) {
    const double kappa = -1.0 + 2e-5 * i;
    ASSERT_EQ(text.at({&kappa, 1}), curvature_factor(kappa, p.actomyosin)) << kappa;
  }
}

TEST(LawsOfThePaper, AreTheFunctionsThatRun) {
  for (const Parameters& p : sets()) {
    compare("fibre_stiffness", p,
            [&](const auto& at) { return fibre_stiffness(at[0], p.fibres) / p.fibres.stiffness; });
    compare("curvature_factor", p, [&](const auto& at) { return curvature_factor(at[0], p.actomyosin); });
    compare("disassembly_rate", p, [&](const auto& at) { return disassembly_rate(at[0], at[1], p.adhesion); });
    compare("growth_force", p, [&](const auto& at) { return area_factor(at[0], p.protrusion); });
    compare("polarization_rate", p, [&](const auto&) { return p.polarization.rate; });
    compare("degradation_tip", p, [&](const auto&) { return p.degradation.tip_rate; });
    for (const bool on_protrusion : {true, false})
      compare(on_protrusion ? "degradation_protrusion" : "degradation_body", p, [&](const auto& at) {
        // within reach, where the cortex does not press
        return degradation_rate(1.39, on_protrusion, 1e-3 * at[1], p);
      });
  }
}

TEST(LawsOfThePaper, OfInitiationAreItsRateAndNoBias) {
  const Parameters p;
  const Row& rate = *find_row("laws.initiation_rate");
  const Row& bias = *find_row("laws.initiation_bias");
  const std::vector<double> anywhere{1.0, 0.2, 0.3, 1.0, 0.5};
  EXPECT_EQ(law_formula(rate, p, std::string(*rate.before)).at(anywhere), p.protrusion.initiation_rate);
  EXPECT_EQ(law_formula(bias, p, std::string(*bias.before)).at(anywhere), 1.0);
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
