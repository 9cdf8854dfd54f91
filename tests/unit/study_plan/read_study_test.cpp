#include "unit/study_plan/studies.hpp"

#include "parameters/laws/constants.hpp"
#include "parameters/presets.hpp"
#include "parameters/schema.hpp"
#include "parameters/write.hpp"
#include "study_plan/names.hpp"
#include "study_plan/study.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace matrigrate::study {
namespace {

TEST(ReadStudy, AGrid) {
  const Study s = read("title = \"T\"\nseed = 7\n[set]\nrun.integrator = \"adaptive\"\n\"run.time_step\" = \"2.4 s\"\n"
                       "[sweep]\n\"ecm.youngs_modulus\" = [\"50 Pa\", 100]\nprotrusion.number = [1, 2, 3]\n");
  EXPECT_EQ(s.title, "T");
  EXPECT_EQ(s.seed, 7U);
  EXPECT_EQ(s.base.run.integrator, Integrator::adaptive);
  ASSERT_EQ(s.points.size(), 6U);
  EXPECT_EQ(s.runs(), 18U);
  EXPECT_EQ(s.points[0].label, "youngs_modulus 50 Pa, n_prot 1");
  EXPECT_EQ(s.points[1].label, "youngs_modulus 50 Pa, n_prot 2") << "the last list changes fastest";
  EXPECT_EQ(s.points[5].settings[0], (Setting{"ecm.youngs_modulus", "\"100 Pa\""}));
  EXPECT_EQ(s.points[5].parameters.ecm.youngs_modulus, 0.1);
  EXPECT_EQ(s.points[5].parameters.run.time_step, 2.4);
  EXPECT_EQ(s.readouts, default_readouts());
}

TEST(ReadStudy, PointsBesideAGrid) {
  const Study s = read("[sweep]\necm.viscosity = [500, 1000]\n[[points]]\nlabel = \"mine\"\necm.youngs_modulus = "
                       "\"30 Pa\"\nadhesion.rupture = true\n[[points]]\nactomyosin.force = \"1 nN\"\n");
  ASSERT_EQ(s.points.size(), 4U);
  EXPECT_EQ(s.points[2].label, "mine");
  EXPECT_TRUE(s.points[2].parameters.adhesion.rupture);
  EXPECT_EQ(s.points[3].label, "force 1 nN");
  EXPECT_EQ(swept_keys(s),
            (std::vector<std::string>{"ecm.viscosity", "ecm.youngs_modulus", "adhesion.rupture", "actomyosin.force"}));
}

TEST(ReadStudy, WithoutAnythingToVary) {
  ASSERT_EQ(read("").points.size(), 1U);
  EXPECT_EQ(read("").points.front().label, "all");
}

TEST(ReadStudy, ALawInOtherWordsIsTheSamePoint) {
  const std::string law = "[set]\nlaws.disassembly_rate = \"r_off_0*exp(-F/F_c)\"\n";
  EXPECT_EQ(fault_of("[sweep]\nlaws.polarization_rate = [\"r_pol/2\", \"r_pol / 2.0\"]\n"),
            "f.toml:4:38: laws.polarization_rate: \"r_pol / 2.0\" is listed twice");
  EXPECT_EQ(fault_of(law + "[sweep]\nlaws.constants = [\"F_c = 50 pN, n = 2\", \"n=2, F_c = 0.050 nN\"]\n"),
            "f.toml:6:41: laws.constants: \"n=2, F_c = 0.050 nN\" is listed twice");
  const auto points = [](const std::string& a, const std::string& b) {
    return "[[points]]\nlabel = \"a\"\n" + a + "\n[[points]]\nlabel = \"b\"\n" + b + "\n";
  };
  EXPECT_EQ(fault_of(law + points("laws.constants = \"F_c = 50 pN\"", "laws.constants = \"F_c = 0.05 nN\"")),
            "f.toml:8:1: points: \"b\": is the same as another point");
  // the law is read with the constants of its point
  EXPECT_EQ(fault_of(points("laws.polarization_rate = \"r_pol*k\"\nlaws.constants = \"k = 2\"",
                            "laws.constants = \"k = 2.0\"\nlaws.polarization_rate = \"( r_pol*k )\"")),
            "f.toml:7:1: points: \"b\": is the same as another point");
  EXPECT_EQ(fault_of("[[conditions]]\nlabel = \"a\"\nlaws.constants = \"k = 50 pN\"\n[[conditions]]\nlabel = \"b\"\n"
                     "laws.constants = \"k=0.05 nN\"\n"),
            "f.toml:6:1: conditions: \"b\": is the same as another condition");
}

/// Seeds follow from what a law means; those of the text that was typed are known as well.
TEST(ReadStudy, ALawInOtherWordsHasTheSameSeeds) {
  const auto study = [](const std::string& value) {
    return read("[sweep]\nlaws.polarization_rate = [\"" + value + "\"]\n");
  };
  const auto runs = [](const Study& s) { return planned_runs(s, values_text); };
  const Study plain = study("r_pol/2"), other = study(" r_pol / 2");
  EXPECT_EQ(runs(plain)[0].seed, runs(other)[0].seed);
  EXPECT_EQ(runs(plain)[0].hash, runs(other)[0].hash);
  EXPECT_NE(runs(plain)[0].seed, runs(study("r_pol/3"))[0].seed);
  EXPECT_EQ(seed_as_typed(plain, runs(plain)[0]), runs(plain)[0].seed)
      << "what is typed in the one spelling has kept its";
  EXPECT_NE(seed_as_typed(other, runs(other)[0]), runs(other)[0].seed);
}

/// A study in which F_s and n are constants.
const std::string slip = "[set]\nlaws.disassembly_rate = \"n*r_off_min*exp(min(20, F/F_s))\"\n"
                         "laws.constants.F_s = { value = \"200 pN\", range = [\"0.1 nN\", \"1 nN\"] }\n"
                         "laws.constants.n = 2\n";

TEST(ReadStudy, AConstantOfTheLawsIsAFactor) {
  const Study s = read(slip + "[sweep]\nlaws.constants.F_s = [\"0.4 nN\", \"100 pN\"]\n");
  ASSERT_EQ(s.points.size(), 2U);
  EXPECT_EQ(s.points[0].label, "F_s 0.4 nN");
  EXPECT_EQ(s.points[1].settings[0], (Setting{"laws.constants.F_s", "\"0.1 nN\""}));
  EXPECT_EQ(constants_text(s.points[1].parameters), "F_s = 0.1 nN, n = 2") << "the other one stays";
  const auto axes = axes_json(s);
  ASSERT_EQ(axes.size(), 1U);
  EXPECT_EQ(axes[0].at("label"), "F_s");
  EXPECT_EQ(axes[0].at("unit"), "nN");
  EXPECT_EQ(axes[0].at("values"), (nlohmann::ordered_json{0.1, 0.4}));
  EXPECT_EQ(Names::whole("laws.constants.F_s"), "F_s");
}

TEST(ReadStudy, AHypercubeDrawsConstantsOfTheLaws) {
  const Study s = read(slip
                       + "[latin_hypercube]\nsamples = 4\nlaws.constants.F_s = [\"100 pN\", \"1 nN\", \"log\"]\n"
                         "laws.constants.n = [1, 3]\n");
  ASSERT_EQ(s.points.size(), 4U);
  for (const Point& point : s.points) {
    const double F_s = find_constant("F_s", point.parameters)->value;
    EXPECT_GE(F_s, 0.1);
    EXPECT_LE(F_s, 1.0);
    EXPECT_TRUE(point_text(s, point.set).starts_with("F_s ")) << point_text(s, point.set);
  }
}

TEST(ReadStudy, AConstantAloneAndAllInOneTextAreTheSameRuns) {
  const auto runs = [](const std::string& sweep) {
    return planned_runs(read(slip + "[sweep]\n" + sweep), values_text);
  };
  const auto alone = runs("laws.constants.F_s = [\"0.1 nN\", \"0.4 nN\"]\n");
  const auto whole = runs("laws.constants = [\"n = 2, F_s = 0.1 nN\", \"F_s = 400 pN, n = 2\"]\n");
  ASSERT_EQ(alone.size(), whole.size());
  for (std::size_t k = 0; k < alone.size(); ++k) {
    EXPECT_EQ(alone[k].seed, whole[k].seed);
    EXPECT_EQ(alone[k].hash, whole[k].hash);
  }
  EXPECT_EQ(
      fault_of(slip
               + "[[points]]\nlaws.constants.F_s = \"0.4 nN\"\n[[points]]\nlaws.constants = \"n = 2, F_s = 0.4 nN\"\n"),
      "f.toml:9:1: points: \"constants n = 2, F_s = 0.4 nN\": is the same as another point");
}

TEST(ReadStudy, AStudyWrittenOutHasItsConstants) {
  const Study s = read(slip + "[sweep]\nlaws.constants.F_s = [\"0.1 nN\", \"0.4 nN\"]\nlaws.constants.n = [1, 3]\n");
  std::string text = to_toml(s, "x.toml");
  const std::string scenario = "scenario = \"x.toml\"";
  text.replace(text.find(scenario), scenario.size(), "preset = \"baseline\"");
  const Study again = parse_study(text + "\n" + slip, "f.toml", ".");
  ASSERT_EQ(again.points.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(again.points[k].settings, s.points[k].settings);
    EXPECT_TRUE(same(again.points[k].parameters, s.points[k].parameters));
  }
}

TEST(ReadStudy, FaultsOfConstantsOfTheLaws) {
  const auto of = [](const std::string& text) { return fault_of(slip + text); };
  EXPECT_EQ(of("[sweep]\nlaws.constants.F_z = [1, 2]\n"),
            "f.toml:8:16: sweep.laws.constants.F_z: there is no such constant; there are F_s, n; did you mean F_s?; "
            "define it in the scenario, below [laws.constants]: F_z = \"0.1 nN\"");
  EXPECT_NE(of("[latin_hypercube]\nsamples = 2\nlaws.constants.F_z = [1, 2]\n").find("there is no such constant"),
            std::string::npos);
  EXPECT_NE(of("[[points]]\nlaws.constants.F_z = 1\n").find("there is no such constant"), std::string::npos);
  EXPECT_EQ(of("[sweep]\nlaws.constants.F_s = [\"0.4 nN\", \"2 nN\"]\n"),
            "f.toml:8:33: laws.constants.F_s: \"2 nN\" is out of range; allowed is >= 0.1 and <= 1 nN");
  EXPECT_NE(of("[sweep]\nlaws.constants.F_s = [\"0.4 Pa\"]\n").find("is a stress, but a force is expected"),
            std::string::npos);
  EXPECT_NE(of("[latin_hypercube]\nsamples = 2\nlaws.constants.F_s = [\"1 nN\", \"0.1 nN\"]\n").find("is not below"),
            std::string::npos);
  EXPECT_NE(of("[sweep]\nlaws.constants.F_s = [\"0.4 nN\", \"400 pN\"]\n").find("is listed twice"), std::string::npos);
  EXPECT_NE(
      of("[sweep]\nlaws.constants.F_s = [\"0.4 nN\"]\n[[conditions]]\nlabel = \"a\"\nlaws.constants = \"n = 1\"\n")
          .find("is also set by the condition \"a\""),
      std::string::npos);
  EXPECT_NE(of("[sweep]\n\"laws.constants\" = [\"n = 1\"]\n\"laws.constants.F_s\" = [1]\n")
                .find("stands beside a constant alone"),
            std::string::npos);
  EXPECT_NE(fault_of("[set]\nlaws.constants.F_s = { value = \"1 nN\", range = [\"2 nN\", \"1 nN\"] }\n")
                .find("laws.constants.F_s: the range of F_s begins at 2 nN"),
            std::string::npos);
}

TEST(ReadStudy, EachFaultOfTheHead) {
  EXPECT_EQ(fault_of("titel = \"x\"\n"), "f.toml:3:1: titel: a study has no such key; did you mean title?");
  EXPECT_EQ(fault_of("title = 3\n"), "f.toml:3:9: title: is a number, but a string in quotes is expected");
  EXPECT_EQ(fault_of("seed = -1\n"), "f.toml:3:8: seed: -1 is out of range; allowed is >= 0 and <= 9007199254740991");
  EXPECT_EQ(fault_of("common_random_numbers = 1\n"),
            "f.toml:3:25: common_random_numbers: is a number; write true or false, without quotes");
  const auto of_readout = [](const std::string& name) { return fault_of("readouts = [\"" + name + "\"]\n"); };
  EXPECT_EQ(of_readout("n_protrusion"),
            "f.toml:3:13: readouts: \"n_protrusion\" is not known; did you mean n_protrusions? "
            "`matrigrate list --readouts-json` lists all "
                + std::to_string(all_readouts().size()));
  EXPECT_NE(of_readout("v_migr_abs").find("did you mean v_migr_abs_um_per_h?"), std::string::npos);
  EXPECT_NE(of_readout("speed").find("did you mean v_migr_abs_um_per_h?"), std::string::npos);
  EXPECT_NE(of_readout("colour").find("is not known; `matrigrate list"), std::string::npos);
  EXPECT_EQ(fault_of("scenario = \"s.toml\"\n"),
            "f.toml:1:10: scenario: is given together with a preset; a study has one of "
            "scenario = \"FILE.toml\" and preset = \"NAME\"");
  EXPECT_THROW(faults_of("scenario = \"nowhere.toml\"\nreplicates = 1\n"), InputOutputError);
  EXPECT_EQ(faults_of("preset = \"sotf\"\nreplicates = 1\n").size(), 1U);
  EXPECT_TRUE(faults_of("preset = \"sotf\"\nreplicates = 1\n")[0].ends_with(
      "; did you mean soft? `matrigrate list` lists all " + std::to_string(presets().size())));
  const auto nothing = faults_of("");
  ASSERT_EQ(nothing.size(), 2U);
  EXPECT_EQ(nothing[0], "f.toml: replicates: is missing; write replicates = 12, the runs at each point");
  EXPECT_EQ(nothing[1],
            "f.toml: scenario: is missing; a study has one of scenario = \"FILE.toml\" and preset = \"NAME\"");
}

TEST(ReadStudy, EachFaultOfASweep) {
  EXPECT_EQ(fault_of("[sweep]\necm.youngs_modulu = [1]\n"),
            "f.toml:4:5: sweep.ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = \"50 um\"\n"),
            "f.toml:4:14: ecm.radius: is a string, but a list of values is expected, such as [\"150 um\"]");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = []\n"),
            "f.toml:4:14: ecm.radius: is empty, but a list of values is expected, such as [\"150 um\"]");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = [\"50 um\", \"5 um\"]\n"),
            "f.toml:4:24: ecm.radius: \"5 um\" is out of range; allowed is >= 10 and <= 2000 um");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = [\"150 um\", \"0.15 mm\"]\n"),
            "f.toml:4:25: ecm.radius: \"150 um\" is listed twice");
  EXPECT_EQ(fault_of("[sweep]\nrun.seed = [1, 2]\n"),
            "f.toml:4:5: sweep.run.seed: the seeds of the runs follow from the study's own `seed`");
  EXPECT_EQ(fault_of("sweep = 3\n"), "f.toml:3:9: sweep: is a number, but a section [sweep] is expected");
}

TEST(ReadStudy, EachFaultOfPoints) {
  EXPECT_EQ(fault_of("points = 3\n"),
            "f.toml:3:10: points: is no list of points; write [[points]] and its parameters below");
  EXPECT_TRUE(fault_of("[[points]]\necm.radius = \"80 um\"\n[[points]]\necm.radius = \"0.08 mm\"\n")
                  .ends_with("is the same as another point"));
  EXPECT_TRUE(fault_of("[[points]]\nlabel = \"a\"\n[[points]]\nlabel = \"a\"\necm.radius = \"80 um\"\n")
                  .ends_with("\"a\": is the label of two points"));
}

TEST(ReadStudy, RulesOnSeveralParametersHoldAtEachPoint) {
  EXPECT_EQ(fault_of("[sweep]\necm.radius = [\"150 um\", \"15 um\"]\n").substr(0, 24), "f.toml:4:25: ecm.radius:");
  EXPECT_EQ(fault_of("[set]\necm.radius = \"15 um\"\n[sweep]\nactomyosin.force = [0.4, 0.6]\n").substr(0, 24),
            "f.toml:4:14: ecm.radius:")
      << "once, though at both points";
}

TEST(ReadStudy, EachFaultOfStatistics) {
  EXPECT_TRUE(fault_of("[statistics]\ncompare = \"controll\"\n").ends_with("; did you mean control?"));
  EXPECT_TRUE(fault_of("[statistics]\ntest = \"welsh\"\n").ends_with("; did you mean welch?"));
  EXPECT_EQ(fault_of("[statistics]\nalpha = 1\n"),
            "f.toml:4:9: statistics.alpha: 1 is out of range; allowed is > 0 and <= 0.5");
  EXPECT_EQ(fault_of("[statistics]\nalpa = 1\n"),
            "f.toml:4:1: statistics.alpa: there is no such key; did you mean alpha?");
  const std::string sweep = "[sweep]\nprotrusion.number = [1, 2]\n[statistics]\ncompare = \"control\"\n";
  EXPECT_TRUE(fault_of(sweep).ends_with("the labels are \"n_prot 1\", \"n_prot 2\"")) << fault_of(sweep);
  EXPECT_TRUE(fault_of(sweep + "control = \"n_prt 1\"\n").ends_with("; did you mean n_prot 1?"));
  EXPECT_EQ(read(sweep + "control = \"n_prot 2\"\n").comparisons.control, "n_prot 2");
}

TEST(ReadStudy, AllFaultsAtOnceAndNoHarmInRubbish) {
  EXPECT_EQ(faults_of("replicates = 0\nseed = \"a\"\ntitle = 3\n[sweep]\necm.radius = [1]\n").size(), 5U);
  EXPECT_EQ(faults_of("replicates = 0\ntitle =\n[sweep]\necm.radius = [1]\n").size(), 1U) << "a syntax error alone";
  EXPECT_EQ(faults_of(std::string("\0\1\2", 3)).size(), 1U);
  EXPECT_THROW(read_study("/nowhere/f.toml"), InputOutputError);
}

TEST(ReadStudy, TheResolvedFormGivesTheSameRuns) {
  const Study s = read("common_random_numbers = true\nreadouts = [\"f_mat\"]\n[sweep]\necm.youngs_modulus = [50, "
                       "100]\n[latin_hypercube]\nsamples = 4\nactomyosin.force = [\"0.4 nN\", \"2 nN\"]\n[statistics]\n"
                       "compare = \"control\"\ncontrol = \"sample 2\"\ntest = \"welch\"\nalpha = 0.01\n");
  std::string text = to_toml(s, "x.toml");
  text.replace(text.find("scenario = \"x.toml\""), 19, "preset = \"baseline\"");
  const Study t = parse_study(text, "f.toml", ".");
  const auto hash = [](const Parameters& p) { return value_text(*find_row("ecm.youngs_modulus"), p); };
  ASSERT_EQ(t.points.size(), s.points.size());
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    EXPECT_EQ(t.points[i].label, s.points[i].label);
    EXPECT_EQ(t.points[i].settings, s.points[i].settings);
    EXPECT_TRUE(same(t.points[i].parameters, s.points[i].parameters));
  }
  const auto a = planned_runs(s, hash);
  const auto b = planned_runs(t, hash);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].seed, b[i].seed);
  EXPECT_EQ(to_toml(t, "x.toml"), to_toml(s, "x.toml"));
}

/// A list of n different values.
std::string list(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += fmt::format("{}{}", i == 0 ? "" : ", ", 100 + i);
  return text;
}

TEST(ReadStudy, PointsAndRunsAreLimitedBeforeTheyAreMade) {
  const std::string head = "preset = \"baseline\"\nreplicates = 100000\n";
  const auto only = [&](const std::string& text) {
    const auto faults = faults_of(head + text);
    return faults.size() == 1 ? faults.front() : fmt::format("{} faults", faults.size());
  };
  EXPECT_EQ(only("[latin_hypercube]\nsamples = 100000\necm.radius = [50, 60]\n"),
            "f.toml:3:1: latin_hypercube.samples: makes 100000 points; with 100000 replicates these are 10000000000 "
            "runs; allowed are 100000");
  EXPECT_EQ(only("[sweep]\necm.radius = [100, 110]\n"),
            "f.toml:3:1: sweep: makes 2 points; with 100000 replicates these are 200000 runs; allowed are 100000");
  EXPECT_EQ(only("[[points]]\nlabel = \"a\"\n[[points]]\necm.radius = 120\n").substr(0, 47),
            "f.toml:3:1: points: makes 2 points; with 100000");
  std::string wide = "[sweep]\n"; // beyond any 64-bit integer
  for (const char* key : {"ecm.radius", "ecm.youngs_modulus", "ecm.viscosity", "protrusion.growth_time",
                          "protrusion.finishing_time", "adhesion.maturation_time", "output.track_interval"})
    wide += fmt::format("{} = [{}]\n", key, list(1000));
  EXPECT_EQ(fault_of(wide),
            "f.toml:3:1: sweep: makes 1e+21 points; with 3 replicates these are 3e+21 runs; allowed are 100000");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = [" + list(1001)
                     + "]\n[latin_hypercube]\nsamples = 33000\n"
                       "ecm.youngs_modulus = [50, 60]\n")
                .substr(0, 68),
            "f.toml:5:1: latin_hypercube.samples: makes 34001 points; with 3 repl")
      << "both together";
}

TEST(ReadStudy, ManyFaultsAreReadInOnePass) {
  std::string keys = "[sweep]\n";
  for (int i = 0; i < 50'000; ++i) keys += fmt::format("k{} = 1\n", i);
  EXPECT_EQ(faults_of("preset = \"baseline\"\nreplicates = 3\n" + keys).back(), "f.toml: has 49800 more faults");
  std::string sections;
  for (int i = 0; i < 90'000; ++i) sections += fmt::format("[s{}]\n", i);
  EXPECT_EQ(faults_of("preset = \"baseline\"\nreplicates = 3\n" + sections).back(), "f.toml: has 89800 more faults");
  EXPECT_EQ(fault_of("[sweep]\necm.radius = [" + list(100'001) + "]\n"),
            "f.toml:4:14: ecm.radius: has 100001 values; allowed are 100000");
  EXPECT_EQ(read("[sweep]\noutput.track_interval = [" + list(20'000) + "]\n").points.size(), 20'000U);
}

TEST(ReadStudy, FurtherRulesAreJudgedOnceForTheSameValues) {
  static int judged = 0;
  judged = 0;
  const std::vector<Rule> more{{"slow", {"ecm.viscosity"}, [](const Parameters& p) {
                                  ++judged;
                                  return p.ecm.viscosity > 2.0 ? std::string("too viscous") : std::string();
                                }}};
  const std::string grid = "preset = \"baseline\"\nreplicates = 3\n[sweep]\nprotrusion.number = [1, 2, 3, 4, 5]\n";
  const auto parse = [&](const std::string& text) {
    return parse_study(text, "f.toml", ".", {.overrides = {}, .replicates = {}, .more = more});
  };
  EXPECT_EQ(parse(grid + "ecm.viscosity = [500, 1000]\n").points.size(), 10U);
  EXPECT_EQ(judged, 2);
  try {
    parse(grid + "ecm.viscosity = [500, 3000]\n");
    FAIL() << "was accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "f.toml:5:23: ecm.viscosity: too viscous");
  }
}

TEST(ReadStudy, RulesOfOneNameAreToldApartByTheirKeys) {
  const auto rule = [](std::string_view key, const char* said) {
    return Rule{"a law", {key}, [said](const Parameters&) { return std::string(said); }, {}, {}, true};
  };
  const std::vector<Rule> more{rule("laws.fibre_stiffness", ""), rule("laws.curvature_factor", "is 2")};
  const std::string text = "preset = \"baseline\"\nreplicates = 3\n[set]\nlaws.fibre_stiffness = \"2\"\n"
                           "laws.curvature_factor = \"2\"\n";
  try {
    parse_study(text, "f.toml", ".", {.overrides = {}, .replicates = {}, .more = more});
    FAIL() << "was accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "f.toml:5:25: laws.curvature_factor: is 2");
  }
}

TEST(ReadStudy, ChangesOfTheCommandLine) {
  Changes changes{{"run.duration=1 h"}, 2};
  const Study s = parse_study("preset = \"soft\"\nreplicates = 12\n", "f.toml", ".", changes);
  EXPECT_EQ(s.replicates, 2U);
  EXPECT_EQ(s.points.front().parameters.run.duration, 3600.0);
  changes.overrides = {"run.duratio=1"};
  EXPECT_THROW(parse_study("preset = \"soft\"\nreplicates = 12\n", "f.toml", ".", changes), ConfigurationError);
}

TEST(ReadStudy, TheStudiesThatShipAreGood) {
  for (const auto& entry : std::filesystem::directory_iterator(MATRIGRATE_SOURCE_DIR "/studies"))
    EXPECT_GT(read_study(entry.path()).runs(), 0U) << entry.path();
}

} // namespace
} // namespace matrigrate::study
