#include "parameters/laws/law.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "faults.hpp"
#include "parameters/laws/constants.hpp"
#include "parameters/laws/law_names.hpp"
#include "parameters/write.hpp"

#include <fmt/format.h>
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
  p.laws.constants = constants_in(constants);
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
    EXPECT_FALSE(is_changed(law, {})) << law.path;
    EXPECT_FALSE(law.arguments.empty()) << law.path;
    const std::string key(key_of(law));
    for (const std::string& known : {usual_text(law), std::string(*law.before)})
      EXPECT_EQ(law_meaning(law, with(key, known + " ")), known) << "finished runs have it in their fingerprints";
    EXPECT_NO_THROW(law_formula(law, {}, text_of(law, {}))) << law.path;
    for (const LawVariable& argument : law_variables(law,
                                                     "x + y + time + density + pressure + f_degr + stiffness + l + "
                                                     "age + t_mat + f_mat",
                                                     {})) {
      EXPECT_LT(argument.low, argument.high) << law.path;
      EXPECT_LE(argument.low, argument.drawn_low) << law.path << " " << argument.name;
      EXPECT_LT(argument.drawn_low, argument.drawn_high) << law.path << " " << argument.name;
      EXPECT_LE(argument.drawn_high, argument.high) << law.path << " " << argument.name;
    }
  }
}

TEST(Law, NamesAreTheSymbolsOfParametersInFormulasUnits) {
  Parameters p;
  p.laws.constants =
      constants_in("F_c = 50 pN, p_0 = 0.1 kPa, n = 2, tau = 1 min, b_p = 2 1/Pa, r_p = 1e-4 1/Pa/s, w = 3 nN/um");
  const std::vector<fields::NamedNumber> names = law_names(row("growth_force"), p);
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
  p.laws.constants = constants_in("g = 5 Pa^0.5");
  const std::vector<fields::NamedNumber> all = law_names(row("growth_force"), p);
  EXPECT_NEAR(std::ranges::find(all, "g", &fields::NamedNumber::name)->value, 5.0, 1e-12);
}

TEST(Law, OfThePaperIsNotChangedBySpelling) {
  EXPECT_TRUE(changed_laws({}).empty());
  EXPECT_TRUE(changed_laws(with("growth_force", "(n_prot>0)and(A>1.0)?1/A:1")).empty());
  EXPECT_EQ(changed_laws(with("growth_force", "n_prot > 0 && A > 1 ? 1/A : 2")).size(), 1U);
}

TEST(Law, KnowsWhatItUses) {
  const Law law("laws.disassembly_rate", with("disassembly_rate", "F*r_off_0/F_c", "F_c = 0.1 nN"));
  EXPECT_TRUE(law.uses("F"));
  EXPECT_FALSE(law.uses("f_mat"));
  EXPECT_TRUE(law.varies());
  EXPECT_FALSE(Law("laws.initiation_rate", {}).varies());
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
  EXPECT_EQ(constants_text(p), "F_c = 0.1 nN, n = 2");
  EXPECT_EQ(constants_text(parse_parameters(to_toml(p), "resolved.toml")), constants_text(p));
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
        Bad{"polarization_rate", "r_pol*l", "there is no l; names here are angle, x, y, time, density"},
        Bad{"initiation_rate", "r_prot*agee", "there is no agee"}, Bad{"maturation", "f_mat", "there is no f_mat"},
        Bad{"fibre_stiffness", "1 + 0*time", "there is no time"},
        Bad{"contraction", "F_am*densty", "did you mean density?"},
        // units and values of arguments that laws share
        Bad{"contraction", "f_mat*F_am*l", " is wanted"},
        Bad{"maturation_force", "x > F_am ? F_am : F", "mixes units at character 1: x is "},
        Bad{"contraction", "-F_am", "is -0.6 nN at any argument; allowed is >= 0 and <= 1000 nN"},
        Bad{"adhesion_stiffness", "k_ad*(1 - stretch)", "is -18 nN/um at stretch = 10 um; allowed is >= 0"},
        Bad{"disassembly_rate", "r_off_min*(1 - age/600)", "at age = 100000 s; allowed is >= 0"},
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
    const std::string law = "[laws]\npolarization_rate = \"r_pol*x_0\"\ninitiation_bias = \"x_0*ligand\"\n";
    const std::string field = "[ecm.fields]\nligand = \"2\"\n";
    std::string told = fault_of(law + "constants = \"" + constants + "\"\n" + field);
    EXPECT_EQ(told.find('\n'), std::string::npos) << told;
    return told;
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
  EXPECT_EQ(of("x_0 = 2"), "0 faults");
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
  p.laws.constants = constants_in(constants);
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
}

// Names that version 0.3.0 left free. What it read means the same.
TEST(LawNames, ThatWereFreeInTheEarlierVersionAreOfConstantsInItsLaws) {
  const Parameters usual;
  for (const std::string name :
       {"F_both", "age", "ceil", "density", "f_curv", "f_degr", "floor", "m_mat", "mod", "pressure", "s_mat", "speed",
        "steps", "stiffness", "stretch", "t_mat", "time", "x", "y"}) {
    SCOPED_TRACE(name);
    const std::string constants = name + " = 3";
    const Parameters rate = with("disassembly_rate", "r_off_min*" + name, constants);
    EXPECT_EQ(fault("disassembly_rate", "r_off_min*" + name, constants), "");
    const Law law("laws.disassembly_rate", rate);
    EXPECT_DOUBLE_EQ(law({0.3, 0.5, 7.0}, {.x = 9.0, .time = 9.0, .age = 9.0}), 3.0 * usual.adhesion.r_off_min);
    EXPECT_FALSE(law.uses_place() || law.varies());
    EXPECT_EQ(law_meaning(row("disassembly_rate"), rate), "r_off_min*" + name);
    EXPECT_EQ(law_notes(rate).size(), 1U);
    const Law growth("laws.growth_force", with("growth_force", "l/100 + t_mat*0 + " + name + "*0 + 2", constants));
    EXPECT_DOUBLE_EQ(growth({1.0, 50.0, 2.0, 4.0}, {.t_mat = 8.0}), 2.5);
    EXPECT_FALSE(growth.uses("speed"));
    EXPECT_EQ(growth.fall(3, {1.0, 50.0, 2.0, 4.0}, {}), 0.0);
    const Laws defaults(with("growth_force", "1", constants)), before(usual);
    EXPECT_EQ(defaults.maturation_force({3.0, 0.3, 60.0}), before.maturation_force({3.0, 0.3, 60.0}));
    EXPECT_EQ(defaults.maturation({3.0}), before.maturation({3.0}));
    EXPECT_EQ(defaults.contraction({0.5, 0.6, 0.1, 0.0}), before.contraction({0.5, 0.6, 0.1, 0.0}));
  }
  EXPECT_EQ(law_notes(with("disassembly_rate", "r_off_min*time", "time = 3")).front(),
            "laws.disassembly_rate names time, your constant, which is also an argument of a law; to use that, give "
            "the constant another name");
  EXPECT_EQ(fault("disassembly_rate", "time", "time = 0.01 1/s"), "") << "its unit is that of the constant";
  EXPECT_NE(fault("disassembly_rate", "time", "time = 1 nN").find("is wanted"), std::string::npos);
}

TEST(LawNames, ThatMayMeanTwoThingsAreRefusedInLawsThatCameLater) {
  const auto told = [](const char* name, const char* owner) {
    return fmt::format("names {}, your constant, which is also {}; give the constant another name", name, owner);
  };
  EXPECT_EQ(fault("maturation", "min(1, 0.09*steps)", "steps = 2"), told("steps", "an argument of a law"));
  EXPECT_EQ(fault("contraction", "F_am*min(1, time/10)", "time = 2 s"), told("time", "an argument of a law"));
  EXPECT_EQ(fault("maturation_force", "s_mat*F_am", "s_mat = 2"), told("s_mat", "adhesion.step_threshold"));
  EXPECT_EQ(fault("adhesion_stiffness", "k_ad*floor", "floor = 2"), told("floor", "known to every formula"));
  EXPECT_EQ(fault("adhesion_stiffness", "k_ad*F_c", "F_c = 2"), "");
  EXPECT_EQ(fault("maturation", "min(1,0.1*steps)", "steps = 2"), "") << "the default is what it was";
  EXPECT_NE(fault_of("[laws]\nmaturation = \"min(1, 0.09*steps)\"\nconstants = \"steps = 2\"\n")
                .find("f.toml:2:14: laws.maturation: names steps"),
            std::string::npos);
  EXPECT_NE(fault_of("laws.constants = \"f_mat = 1\"").find("f_mat is taken"), std::string::npos);
}

/// What laws.constants mean.
std::string meaning(const std::string& constants) {
  Parameters p;
  p.laws.constants = constants_in(constants);
  return constants_text(p);
}

TEST(LawMeaning, OfConstantsIsTheirValueInTheUnitOfFormulas) {
  for (const char* one : {"F_c = 0.05 nN", "F_c=50 pN", " F_c  =  0.050 nN ", "F_c = 5e-2 nN", "F_c = 5e-11 N",
                          "F_c = 0.05 kPa um^2", "F_c = 50 mg um/s^2"})
    EXPECT_EQ(meaning(one), "F_c = 0.05 nN") << one;
  for (const char* one : {"p_0 = 1 nN/um^2", "p_0 = 1 kPa", "p_0 = 1000 Pa", "p_0 = 1 mN/mm^2", "p_0 = 1000 kg/m/s^2"})
    EXPECT_EQ(meaning(one), "p_0 = 1000 Pa") << one;
  EXPECT_EQ(meaning("r = 12 1/min"), "r = 0.2 1/s");
  EXPECT_EQ(meaning("b = 1e-4 1/Pa/s"), "b = 0.0001 1/Pa/s");
  EXPECT_EQ(meaning("mu_0 = 1 nN s/um^2"), "mu_0 = 1000 Pa s");
  EXPECT_EQ(meaning("w = 3 mN/m"), "w = 3 nN/um");
  EXPECT_EQ(meaning("n = 2.0, a = 1"), "a = 1, n = 2") << "in any order";
  EXPECT_EQ(meaning(""), "");
  EXPECT_EQ(meaning("  "), "");
  EXPECT_NE(meaning("F_c = 0.05 nN"), meaning("F_c = 0.051 nN"));
  EXPECT_NE(meaning("F_c = 0.05 nN"), meaning("F_c = 0.05"));
}

TEST(LawMeaning, OfAFormulaIsItsTree) {
  const auto same_as = [](const char* a, const char* b) {
    return !differs(row("disassembly_rate"), with("disassembly_rate", a, "F_c = 1 nN, power = 2"),
                    with("disassembly_rate", b, "F_c = 1 nN, power = 2"));
  };
  for (const char* spelling : {"r_off_min*F/F_c", " r_off_min * F /F_c ", "(r_off_min*F)/F_c", "((r_off_min)*(F))/F_c",
                               "r_off_min\u00b7F\u00f7F_c", "+r_off_min*F/F_c"})
    EXPECT_TRUE(same_as("r_off_min*F/F_c", spelling)) << spelling;
  EXPECT_TRUE(same_as("0.5*F^2", ".50*F**2.0"));
  EXPECT_TRUE(same_as("F^2", "pow(F, 2)"));
  EXPECT_TRUE(same_as("F > 1 ? 1 : 2", "if(F>1,1,2)"));
  EXPECT_TRUE(same_as("_pi*F", "pi*F"));
  EXPECT_FALSE(same_as("r_off_min*F/F_c", "F*r_off_min/F_c")) << "other bits";
  EXPECT_FALSE(same_as("r_off_min*F/F_c", "r_off_min*(F/F_c)"));
  EXPECT_FALSE(same_as("F*power", "F*2"));
  EXPECT_FALSE(same_as("0.5*F", "0.51*F"));
}

TEST(LawMeaning, IsWhatTheFingerprintAndTheComparisonTake) {
  const Parameters a = with("disassembly_rate", "1e-3*F/F_c", "F_c = 50 pN, n = 2");
  const Parameters b = with("disassembly_rate", "0.001 * F / F_c", "n=2.0,F_c=0.05 nN");
  EXPECT_EQ(values_text(a), values_text(b));
  EXPECT_TRUE(same(a, b));
  EXPECT_FALSE(same(a, with("disassembly_rate", "1e-3*F/F_c", "F_c = 51 pN, n = 2")));
  EXPECT_NE(to_toml(a).find("disassembly_rate = \"1e-3*F/F_c\"\n"), std::string::npos) << "files keep what was typed";
  EXPECT_EQ(values_text(with("curvature_factor", "exp(-0.5*((kappa-kappa_0)/kappa_w)^2)")).find("laws"),
            std::string::npos)
      << "the default of the versions without these keys";
}

// In formulas stresses are in Pa, beside nN and um.
TEST(LawUnits, OfStressesAndForcesAgreeByTheirFactor) {
  EXPECT_EQ(fault("degradation_body", "p > p_0 ? r_degr_body : 0", "p_0 = 1 nN/um^2"), "");
  const auto told = [](const char* formula, const char* constants) {
    return fault("degradation_body", formula, constants);
  };
  EXPECT_NE(told("p*a > F_0 ? r_degr_body : 0", "a = 1 um^2, F_0 = 1 nN")
                .find("p*a is in Pa um^2, but F_0 is in nN; 1 Pa is 1e-3 nN/um^2"),
            std::string::npos);
  EXPECT_EQ(told("1e-3*p*a > F_0 ? r_degr_body : 0", "a = 1 um^2, F_0 = 1 nN"), "") << "the factor is written out";
  EXPECT_NE(told("r_degr_body*exp(-abs(p)*a/F_0)", "a = 1 um^2, F_0 = 1 nN").find("is in Pa um^2/nN, but exp takes"),
            std::string::npos);
  EXPECT_NE(told("abs(p)*a*r", "a = 1 um^2, r = 1 1/s/nN").find("is in Pa um^2/nN/s, but is to be in 1/s"),
            std::string::npos);
  EXPECT_NE(told("p > g*x_0 ? r_degr_body : 0", "g = 5 Pa/um, x_0 = 1 um")
                .find("p is in Pa, but g*x_0 is in nN/um^2; 1 Pa is 1e-3 nN/um^2"),
            std::string::npos)
      << "a gradient of stress is in nN/um^3";
  EXPECT_EQ(told("abs(p)/E*r_degr_body/1000", ""), "") << "both in Pa";
}

TEST(LawRanges, StandInThePageOfLaws) {
  const std::string page = read_file(std::string(MATRIGRATE_SOURCE_DIR) + "/docs/how-to/laws.md", std::size_t{1} << 20);
  for (const Row& law : law_rows())
    for (const LawVariable& argument :
         law_variables(law, "x y time density pressure f_degr stiffness l age t_mat f_mat", {})) {
      const std::string line =
          "`" + std::string(argument.name) + "` | " + range_text(argument) + " | " + std::string(argument.meaning);
      EXPECT_NE(page.find(line), std::string::npos) << law.path << ": " << line;
    }
}

TEST(LawNotes, SayWhatIsDoubtful) {
  Parameters p;
  EXPECT_TRUE(law_notes(p).empty());
  p.laws.initiation_rate = "r_prot*(angle < 90)";
  p.laws.constants = constants_in("n = 2, F_c = 1 nN");
  std::vector<std::string> notes = law_notes(p);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].find("laws.initiation_rate: angle < 90, at character 8, holds wherever the law is judged"), 0U)
      << notes[0];
  EXPECT_EQ(notes[2].find("laws.constants: n stands in no law"), 0U) << notes[2];
  p.laws.initiation_rate = "n*r_prot*(angle < 1)";
  EXPECT_EQ(law_notes(p).size(), 1U) << "F_c alone";
}

TEST(LawFaults, OfShortNamesListWhatThereIs) {
  Parameters p;
  p.laws.disassembly_rate = "z*r_off_min";
  const std::string fault = fault_of_law(p, *find_row("laws.disassembly_rate"));
  EXPECT_NE(fault.find("there is no z; names here are F, f_mat, t, x, y, time, density, pressure, f_degr, "
                       "stiffness, l, age, t_mat, and symbols of parameters"),
            std::string::npos)
      << fault;
}

} // namespace
} // namespace matrigrate
