#include "parameters/laws/law.hpp"

#include "base/failure.hpp"
#include "faults.hpp"
#include "parameters/laws/law_values.hpp"
#include "parameters/laws/laws.hpp"
#include "parameters/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace matrigrate {
namespace {

const Row& row(const std::string& key) { return *find_row("laws." + key); }

Parameters with(const std::string& key, const std::string& formula, const std::string& constants = "") {
  Parameters p;
  std::get<std::string& (*)(Parameters&)>(row(key).member)(p) = formula;
  p.laws.constants = constants;
  return p;
}

/// What is wrong with the text of a law, or else with its values.
std::string fault(const std::string& key, const std::string& formula, const std::string& constants = "") {
  const Parameters p = with(key, formula, constants);
  std::string said = fault_of_law(p, row(key));
  return said.empty() ? fault_of_law_values(p, row(key)) : said;
}

TEST(Law, DefaultsAreNotChangedAndCanBeRead) {
  for (const Row& law : law_rows()) {
    ASSERT_TRUE(law.before) << law.path;
    if (kind(law) != Kind::law) continue;
    EXPECT_FALSE(is_changed(law, {})) << law.path;
    EXPECT_FALSE(law_variables(law).empty()) << law.path;
    EXPECT_NO_THROW(law_formula(law, {}, text_of(law, {}))) << law.path;
    for (const LawVariable& variable : law_variables(law)) {
      EXPECT_LT(variable.low, variable.high) << law.path;
      EXPECT_NE(law.description.find(variable.name), std::string_view::npos) << law.path << " " << variable.name;
    }
  }
  EXPECT_EQ(law_rows().back().path, "laws.constants");
}

TEST(Law, NamesAreTheSymbolsOfParametersInFormulasUnits) {
  Parameters p;
  p.laws.constants = "F_c = 50 pN, p_0 = 0.1 kPa, n = 2, tau = 1 min, b_p = 2 1/Pa, r_p = 1e-4 1/Pa/s, w = 3 nN/um";
  const std::vector<fields::NamedNumber> names = law_names(p);
  const auto value = [&](std::string_view name) {
    const auto found = std::ranges::find(names, name, &fields::NamedNumber::name);
    return found == names.end() ? std::nan("") : found->value;
  };
  EXPECT_DOUBLE_EQ(value("zeta_diss"), 20.0);
  EXPECT_DOUBLE_EQ(value("p_th_degr"), 20.0) << "Pa";
  EXPECT_DOUBLE_EQ(value("E"), 200.0) << "Pa";
  EXPECT_DOUBLE_EQ(value("mu"), 1000.0) << "Pa s";
  EXPECT_DOUBLE_EQ(value("k_ad"), 2.0) << "nN/um";
  EXPECT_DOUBLE_EQ(value("n_prot"), 0.0);
  EXPECT_DOUBLE_EQ(value("F_c"), 0.05);
  EXPECT_DOUBLE_EQ(value("b_p"), 2.0) << "1/Pa, so that b_p*p is a number";
  EXPECT_DOUBLE_EQ(value("r_p"), 1e-4) << "1/Pa/s";
  EXPECT_DOUBLE_EQ(value("w"), 3.0) << "nN/um";
  EXPECT_DOUBLE_EQ(value("p_0"), 100.0);
  EXPECT_DOUBLE_EQ(value("n"), 2.0);
  EXPECT_DOUBLE_EQ(value("tau"), 60.0);
  EXPECT_TRUE(std::isnan(value("dt"))) << "a law does not depend on numerics";
  EXPECT_TRUE(std::isnan(value("f_mat"))) << "the variable";
  std::set<std::string> once;
  for (const fields::NamedNumber& name : names) EXPECT_TRUE(once.insert(name.name).second) << name.name;
  for (const char* mixed : {"g = 5 Pa/um", "g = 5 kPa um", "g = 1 Pa s/um"}) {
    Parameters wrong;
    wrong.laws.constants = mixed;
    EXPECT_NE(fault_of_constants(wrong).find("mixes Pa with another length"), std::string::npos) << mixed;
  }
  p.laws.constants = "g = 5 Pa^0.5";
  const std::vector<fields::NamedNumber> all = law_names(p);
  EXPECT_NEAR(std::ranges::find(all, "g", &fields::NamedNumber::name)->value, 5.0, 1e-12);
}

TEST(Law, OfThePaperIsNoFormula) {
  const Parameters p;
  EXPECT_FALSE(Law("laws.curvature_factor", p).changed());
  EXPECT_FALSE(Law().changed());
  EXPECT_FALSE(usual_laws().disassembly_rate.changed());
  EXPECT_FALSE(Laws(p).growth_force.changed());
  EXPECT_TRUE(changed_laws(p).empty());
}

TEST(Law, KnowsWhatItUses) {
  const Law law("laws.disassembly_rate", with("disassembly_rate", "F*r_off_0/F_c", "F_c = 0.1 nN"));
  EXPECT_TRUE(law.uses("F"));
  EXPECT_FALSE(law.uses("f_mat"));
  EXPECT_FALSE(law.uses("G"));
  EXPECT_DOUBLE_EQ(law({0.05, 1.0, 0.0}), 0.1);
}

TEST(Law, StopsARunWhereItsValueIsNotAllowed) {
  const Law law("laws.curvature_factor", with("curvature_factor", "kappa == 0.123456 ? 2 : 1"));
  EXPECT_EQ(law({0.0}), 1.0);
  try {
    law({0.123456});
    FAIL();
  } catch (const NumericalFailure& failure) {
    EXPECT_EQ(failure.cause(), FailureCause::law);
    EXPECT_EQ(std::string(failure.what()),
              "laws.curvature_factor is 2 at kappa = 0.123456 1/um; allowed is >= 0 and <= 1; "
              "min(1, ...) keeps it from rising above");
  }
}

TEST(Law, ConstantsAreReadFromATableAsWell) {
  const Parameters p =
      parse_parameters("[laws.constants]\nF_c = \"0.1 nN\"\nn = 2\n[laws]\ngrowth_force = \"n/2\"\n", "f.toml");
  EXPECT_EQ(p.laws.constants, "F_c = 0.1 nN, n = 2");
  EXPECT_EQ(parse_parameters(to_toml(p), "resolved.toml").laws.constants, p.laws.constants);
  EXPECT_NE(values_text(p).find("laws.constants = \"F_c = 0.1 nN, n = 2\"\n"), std::string::npos);
}

TEST(Law, OfAllVersionsNamesNoRunAnew) {
  const Parameters second = with("curvature_factor", "exp(-0.5*((kappa - kappa_0)/kappa_w)^2)");
  EXPECT_EQ(values_text(second).find("laws"), std::string::npos) << "the default of the versions without these keys";
  EXPECT_NE(values_text({}).find("laws.curvature_factor = \"exp(-((kappa - kappa_0)/kappa_w)^2)\"\n"),
            std::string::npos);
  const Parameters p = with("polarization_rate", "r_pol/2");
  EXPECT_NE(values_text(p).find("laws.polarization_rate = \"r_pol/2\"\n"), std::string::npos);
}

TEST(LawCurves, AreThoseOfEachVariableThatMatters) {
  const auto over = [](const char* law, const char* formula) {
    std::vector<std::string> names;
    for (const LawCurve& curve : law_curves(with(law, formula), row(law), 11)) names.emplace_back(curve.over.name);
    return names;
  };
  EXPECT_EQ(over("disassembly_rate", "1e-3*t/100"), std::vector<std::string>{"t"});
  EXPECT_EQ(over("disassembly_rate", "1e-3*t/100*f_mat"), (std::vector<std::string>{"f_mat", "t"}));
  EXPECT_EQ(over("growth_force", "0.5"), std::vector<std::string>{"A"}) << "on which the paper's depends";
  EXPECT_EQ(over("initiation_rate", "2*r_prot"), std::vector<std::string>{"angle"}) << "neither depends on anything";
  const LawCurve bias = law_curves(with("initiation_bias", "exp(2*occupancy)"), row("initiation_bias"), 11).front();
  EXPECT_EQ(bias.over.name, "occupancy");
  EXPECT_EQ(bias.at, "") << "nothing else matters";
  EXPECT_EQ(law_curves(with("disassembly_rate", "1e-3*t/100"), row("disassembly_rate"), 2)[0].at,
            "F = 0.3 nN, f_mat = 0.5")
      << "on which the paper's depends";
  EXPECT_DOUBLE_EQ(bias.changed.back(), std::exp(2.0));
  EXPECT_DOUBLE_EQ(bias.usual.back(), 1.0);
}

/// A formula that is refused, and what is said of it.
struct Bad {
  const char* law;
  const char* formula;
  const char* said; ///< part of the fault
  const char* constants = "";
};

class BadLaw : public testing::TestWithParam<Bad> {};

TEST_P(BadLaw, IsRefusedWithItsPlace) {
  const Bad bad = GetParam();
  const std::string formula = bad.formula;
  const std::string said = fault(bad.law, formula, bad.constants);
  EXPECT_NE(said.find(bad.said), std::string::npos) << formula << "\n" << said;
  EXPECT_LT(said.size(), 500U);
}

const std::string long_formula(2500, '1');
const std::string ten_kilobytes = [] {
  std::string text = "1";
  while (text.size() < 10'000) text += " + 1";
  return text;
}();
const std::string nested(999, '(');

INSTANTIATE_TEST_SUITE_P(
    Forty, BadLaw,
    testing::Values(
        // syntax
        Bad{"curvature_factor", "", "cannot be read as a formula in kappa"},
        Bad{"curvature_factor", "exp(", "at character"}, Bad{"curvature_factor", "1 +", "at character"},
        Bad{"curvature_factor", "(1", "cannot be read"}, Bad{"curvature_factor", "1)", "at character 2"},
        Bad{"curvature_factor", "1 2", "at character 3"}, Bad{"curvature_factor", "1 ? 2", "cannot be read"},
        Bad{"curvature_factor", "exp()", "cannot be read"}, Bad{"curvature_factor", "exp(1, 2)", "cannot be read"},
        Bad{"curvature_factor", "\"text\"", "cannot be read"}, Bad{"curvature_factor", "0.5 $ 1", "at character 5"},
        Bad{"curvature_factor", "0,5*kappa", "at character 2: a comma stands outside of a function; write 0.5"},
        Bad{"curvature_factor", "min(1, 0,5)*kappa, 1", "a comma stands outside"},
        Bad{"curvature_factor", "kappa = 1", "at character 7: = would set a value"},
        Bad{"curvature_factor", "x = 1", "at character 3: = would set a value"},
        Bad{"curvature_factor", "while(1) 1", "there is no while"},
        Bad{"curvature_factor", ten_kilobytes.c_str(), "allowed are 1000"},
        Bad{"curvature_factor", long_formula.c_str(), "is a formula of 2500 characters"},
        Bad{"curvature_factor", nested.c_str(), "cannot be read"},
        // names
        Bad{"curvature_factor", "kapa", "at character 1: there is no kapa; did you mean kappa?"},
        Bad{"curvature_factor", "exp(-kappa/kappa_W)", "did you mean kappa_w?"},
        Bad{"curvature_factor", "F", "there is no F"}, Bad{"disassembly_rate", "r_off_min*kappa", "there is no kappa"},
        Bad{"disassembly_rate", "curvature_factor(F)", "there is no curvature_factor"},
        Bad{"disassembly_rate", "disassembly_rate", "there is no disassembly_rate"},
        Bad{"disassembly_rate", "exp(-F/F_c)", "did you mean F_cc?", "F_cc = 1 nN"},
        Bad{"polarization_rate", "r_pol*dt", "there is no dt"}, Bad{"polarization_rate", "rand()", "there is no rand"},
        // values
        Bad{"curvature_factor", "2", "is 2 at any argument; allowed is >= 0 and <= 1; min(1, ...)"},
        Bad{"curvature_factor", "kappa", "is -5 at kappa = -5 1/um; allowed is >= 0 and <= 1; max(0, ...)"},
        Bad{"curvature_factor", "1/kappa", "at kappa = "},
        Bad{"curvature_factor", "abs(sin(kappa)/kappa)",
            "is not a number at kappa = 0 1/um (sin(kappa)/kappa, at character 5, is not a number); "
            "allowed is >= 0 and <= 1"},
        Bad{"curvature_factor", "0.5 + 0*log(kappa)", "log(kappa), at character 9, is not a number"},
        Bad{"curvature_factor", "0.5 + 0*sqrt(1 - kappa)", "sqrt(1 - kappa), at character 9, is "},
        Bad{"curvature_factor", "(kappa - kappa_0)/(kappa - kappa_0)", "at kappa = -0.15 1/um"},
        Bad{"curvature_factor", "kappa == 0.1234 ? 0/0 : 1", "at kappa = 0.1234 1/um"},
        Bad{"disassembly_rate", "-r_off_min", "is -0.000278 1/s at any argument; allowed is >= 0 and <= 1e+06 1/s"},
        Bad{"disassembly_rate", "r_off_min - F", "; allowed is >= 0"},
        Bad{"disassembly_rate", "exp(F/0.001)",
            "; allowed is >= 0 and <= 1e+06 1/s; min(1e+06, ...) keeps it from rising above"},
        Bad{"disassembly_rate", "r_off_0/F", "r_off_0/F, at character 1, is infinite"},
        Bad{"fibre_stiffness", "1 - eps*3", "is -2 at eps = 1; allowed is >= 0"},
        Bad{"growth_force", "1 - l/20",
            "is -4 at l = 100 um; allowed is >= 0 and <= 100; max(0, ...) keeps it from falling below"},
        Bad{"growth_force", "1e200", "; allowed is >= 0 and <= 100"},
        Bad{"degradation_body", "r_degr_body*p", "p = -10000 Pa"},
        Bad{"initiation_bias", "exp(1000*occupancy)", "allowed is >= 0 and <= 1e+300"},
        // comparisons of three
        Bad{"disassembly_rate", "0.05 < F < 0.2 ? 0.0001 : 0.01",
            "at character 10: < 0.2 would compare 0 or 1 with 0.2, since 0.05 < F is 0 or 1; compare twice: 0.05 < F "
            "&& F < "
            "0.2"},
        Bad{"growth_force", "A == l == t ? 0 : 1", "compare twice: A == l && l == t"},
        Bad{"initiation_rate", "-cos(angle)", "at angle = "}));

TEST(LawFaults, OfConstantsAreToldOnce) {
  const auto of = [](const std::string& constants) {
    Parameters p = with("polarization_rate", "r_pol*x_0", constants);
    EXPECT_EQ(fault_of_law(p, row("polarization_rate")), "") << constants;
    return fault_of_constants(p);
  };
  EXPECT_NE(of("x_0").find("\"x_0\" is not of the form name = value"), std::string::npos);
  EXPECT_NE(of("x_0 = 0,1").find("is not of the form name = value"), std::string::npos);
  EXPECT_NE(of("0x = 1").find("is no name"), std::string::npos);
  EXPECT_NE(of("x_0 = ").find("the value of x_0"), std::string::npos);
  EXPECT_NE(of("x_0 = 1 parsec").find("the value of x_0"), std::string::npos);
  EXPECT_NE(of("x_0 = 1, x_0 = 2").find("x_0 is given twice"), std::string::npos);
  EXPECT_NE(of("zeta_diss = 1").find("taken: it is adhesion.zeta_diss"), std::string::npos);
  EXPECT_NE(of("kappa = 1").find("taken: it is an argument of a law"), std::string::npos);
  EXPECT_NE(of("sin = 1").find("taken: it is known to every formula"), std::string::npos);
  EXPECT_EQ(of("x_0 = 2"), "");
}

TEST(LawFaults, StandAtTheirKeys) {
  EXPECT_EQ(fault_of("[laws]\npolarization_rate = \"r_pool\"\n"),
            "f.toml:2:21: laws.polarization_rate: cannot be read as a formula in angle, at character 1: there is no "
            "r_pool; did you mean r_pol?");
  EXPECT_EQ(
      fault_of("[laws]\npolarization_rate = true\n"),
      "f.toml:2:21: laws.polarization_rate: is a flag; write a formula in angle of values >= 0 and <= 1e6 1/s, in "
      "quotes");
  EXPECT_EQ(parse_parameters("laws.polarization_rate = 0.001", "f.toml").laws.polarization_rate, "0.001");
  EXPECT_EQ(parse_parameters("laws.polarization_rate = 0", "f.toml").laws.polarization_rate, "0");
  EXPECT_NE(fault_of("[laws]\nconstants = \"r_pol = 1\"\n").find("f.toml:2:13: laws.constants: r_pol is taken"),
            std::string::npos);
  EXPECT_NE(fault_of("[laws.constants]\nx_0 = true\n").find("the value of x_0"), std::string::npos);
  EXPECT_NE(fault_of("[laws]\ncurvature_facter = \"1\"\n").find("did you mean laws.curvature_factor?"),
            std::string::npos);
  EXPECT_NE(fault_of("", {"laws.initiation_bias=exp(3*occupancy)"}).find("there is no attractant to sense"),
            std::string::npos);
}

/// What is wrong with the disassembly rate and constants.
std::string fault_of_rate(const std::string& law, const std::string& constants) {
  Parameters p;
  p.laws.disassembly_rate = law;
  p.laws.constants = constants;
  return fault_of_law_values(p, *find_row("laws.disassembly_rate"));
}

TEST(LawUnits, OfSumsFunctionsAndTheWholeAgree) {
  const std::string slip = "r_off_min + r_c*exp(-F/F_c)";
  EXPECT_EQ(fault_of_rate(slip, "r_c = 0.2 1/s, F_c = 50 pN"), "");
  EXPECT_EQ(fault_of_rate(slip, "r_c = 12 1/min, F_c = 0.05 nN"), "");
  EXPECT_NE(fault_of_rate(slip, "r_c = 0.2 1/s, F_c = 50 Pa").find("exp takes a number without a unit"),
            std::string::npos);
  EXPECT_NE(fault_of_rate(slip, "r_c = 0.2 s, F_c = 50 pN").find("r_off_min is "), std::string::npos);
  EXPECT_NE(fault_of_rate("k*F", "k = 1 1/s").find(" is wanted"), std::string::npos);
  EXPECT_EQ(fault_of_rate("k*F", "k = 1e-3 1/s/nN"), "");
  EXPECT_EQ(fault_of_rate("k*min(F, F_c)^2", "k = 1e-3 1/s/nN^2, F_c = 1 nN"), "");
  EXPECT_NE(fault_of_rate("F > t_c ? r_off_min : r_off_0", "t_c = 1 s").find("at character 1: F is "),
            std::string::npos);
  EXPECT_NE(fault_of_rate("F > F_c ? r_off_min : F", "F_c = 1 nN").find("r_off_min is "), std::string::npos);
  EXPECT_EQ(fault_of_rate("F > 0.2 ? 1e-4 : r_off_min", ""), "") << "a number that is written out fits everywhere";
  EXPECT_EQ(fault_of_rate("1e-3*F/(f_mat*F_both)", ""), "") << "the share of the pull of both strands";
}

// Eq. 9 and the rupture ratio take the force of both strands.
TEST(LawNames, HaveThePullOfBothStrands) {
  Parameters p;
  p.laws.disassembly_rate = "1e-3*F/(f_mat*F_both)";
  EXPECT_DOUBLE_EQ(Law("laws.disassembly_rate", p)({0.6, 0.5, 0.0}), 1e-3 * 0.6 / (0.5 * 2.0 * p.actomyosin.force));
  p.laws.constants = "F_both = 1 nN";
  EXPECT_NE(fault_of_constants(p).find("F_both is taken"), std::string::npos);
}

TEST(LawNotes, SayWhatIsDoubtful) {
  Parameters p;
  EXPECT_TRUE(law_notes(p).empty());
  p.laws.initiation_rate = "r_prot*(angle < 90)";
  p.laws.constants = "n = 2, F_c = 1 nN";
  std::vector<std::string> notes = law_notes(p);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].find("laws.initiation_rate: angle < 90, at character 8, holds wherever the law is judged"), 0U)
      << notes[0];
  EXPECT_EQ(notes[1].find("laws.constants: n stands in no law"), 0U) << notes[1];
  p.laws.initiation_rate = "n*r_prot*(angle < 1)";
  EXPECT_EQ(law_notes(p).size(), 1U) << "F_c alone";
}

TEST(LawFaults, OfShortNamesListWhatThereIs) {
  Parameters p;
  p.laws.disassembly_rate = "x*r_off_min";
  const std::string fault = fault_of_law(p, *find_row("laws.disassembly_rate"));
  EXPECT_NE(fault.find("there is no x; names here are F, f_mat, t, and symbols of parameters"), std::string::npos)
      << fault;
}

} // namespace
} // namespace matrigrate
