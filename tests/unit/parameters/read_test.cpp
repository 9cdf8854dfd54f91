#include "base/file.hpp"
#include "faults.hpp"
#include "fields/file_words.hpp"
#include "fields/grids.hpp"
#include "parameters/schema.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace matrigrate {
namespace {

TEST(Read, AnEmptyTextIsAllDefaults) {
  EXPECT_TRUE(same(parse_parameters("", "f.toml"), Parameters{}));
  EXPECT_TRUE(same(parse_parameters("# nothing\n\n[ecm]\n[run]\n", "f.toml"), Parameters{}));
  EXPECT_TRUE(same(parse_parameters("\xef\xbb\xbf", "f.toml"), Parameters{}));
}

TEST(Read, KeepsTheGridsThatFieldsName) {
  const auto file = std::filesystem::temp_directory_path() / ("E_" + std::to_string(::getpid()) + ".csv");
  write_file(file, "x_um,y_um,E\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n");
  const std::string text = "[ecm.fields]\nyoungs_modulus = \"" + file.string() + "\"\n";
  const Parameters p = parse_parameters(text, "f.toml"), other = parse_parameters(text, "f.toml");
  const auto grid = [](const Parameters& of) {
    return of.grids->of(*fields::file_words(of.ecm.fields.youngs_modulus), "").grid;
  };
  EXPECT_EQ(grid(apply_overrides(p, {"run.seed=2"})), grid(p)) << "the one that was read first";
  EXPECT_NE(grid(other), grid(p)) << "nothing is shared by the whole program";
  std::filesystem::remove(file);
}

TEST(Read, EveryKindIsRead) {
  const Parameters p = parse_parameters("[run]\nduration = \"30 min\"\nseed = 7\nthreads = 0\n"
                                        "[ecm]\nyoungs_modulus = 400\npoissons_ratio = 0.3\nviscosity = \"0.5 kPa s\"\n"
                                        "lattice = \"hexagonal\"\ncell_hole = false\nradius = 120\n",
                                        "f.toml");
  EXPECT_EQ(p.run.duration, 1800.0);
  EXPECT_EQ(p.run.seed, 7u);
  EXPECT_EQ(p.run.threads, 0);
  EXPECT_EQ(p.ecm.youngs_modulus, 0.4);
  EXPECT_EQ(p.ecm.poissons_ratio, 0.3);
  EXPECT_EQ(p.ecm.viscosity, 0.5);
  EXPECT_EQ(p.ecm.lattice, Lattice::hexagonal);
  EXPECT_FALSE(p.ecm.cell_hole);
  EXPECT_EQ(p.ecm.radius, 120.0);
  EXPECT_EQ(p.ecm.smoothing_length, Parameters{}.ecm.smoothing_length);
}

TEST(Read, AStepThatNobodyNamesIsThatOfTheIntegrator) {
  const std::string adaptive = "run.integrator = \"adaptive\"\n";
  EXPECT_EQ(parse_parameters(adaptive, "f.toml").run.time_step, usual_time_step(Integrator::adaptive));
  EXPECT_EQ(parse_parameters(adaptive + "run.time_step = 3\n", "f.toml").run.time_step, 3.0);
  EXPECT_EQ(parse_parameters(adaptive, "f.toml", {"run.integrator=reference"}).run.time_step, 0.4);
  const Parameters p = parse_parameters(adaptive, "f.toml");
  EXPECT_EQ(apply_overrides(p, {"run.integrator=reference"}).run.time_step, 0.4);
  EXPECT_EQ(apply_overrides(p, {"run.seed=2"}).run.time_step, p.run.time_step);
  const Parameters own = parse_parameters(adaptive + "run.time_step = 3\n", "f.toml");
  EXPECT_EQ(apply_overrides(own, {"run.integrator=reference", "run.duration=1 h"}).run.time_step, 3.0);
}

TEST(Read, ABareNumberIsInTheUnitOfTheRow) {
  EXPECT_EQ(parse_parameters("run.duration = 6", "f.toml").run.duration, 21600.0);
  EXPECT_EQ(parse_parameters("ecm.youngs_modulus = 200.0", "f.toml").ecm.youngs_modulus, 0.2);
  EXPECT_EQ(parse_parameters("ecm.youngs_modulus = 0.7", "f.toml").ecm.youngs_modulus, 0.0007);
  EXPECT_EQ(parse_parameters("ecm = { viscosity = 1000 }", "f.toml").ecm.viscosity, 1.0);
}

TEST(Read, LineEndingsAndByteOrderMarkDoNotMatter) {
  const Parameters p = parse_parameters("\xef\xbb\xbf[ecm]\r\nyoungs_modulus = \"400 Pa\"\r\n", "f.toml");
  EXPECT_EQ(p.ecm.youngs_modulus, 0.4);
  EXPECT_EQ(fault_of("\xef\xbb\xbf[ecm]\r\nradius = 1\r\n"),
            "f.toml:2:10: ecm.radius: 1 um is out of range; allowed is >= 10 and <= 2000 um");
  EXPECT_EQ(fault_of("\xef\xbb\xbfrum = 1"), "f.toml:1:1: rum: there is no such parameter; did you mean run?");
}

struct Faulty {
  const char* text;
  const char* fault;
};

class OneFault : public testing::TestWithParam<Faulty> {};

TEST_P(OneFault, IsToldWithItsPlace) { EXPECT_EQ(fault_of(GetParam().text), GetParam().fault); }

INSTANTIATE_TEST_SUITE_P(
    Names, OneFault,
    testing::Values(
        Faulty{"[ecm]\n  youngs_modulu = 1\n",
               "f.toml:2:3: ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?"},
        Faulty{"[cell]\nviscosity = 1\n",
               "f.toml:2:1: cell.viscosity: there is no such parameter; did you mean ecm.viscosity?"},
        Faulty{"[ecm]\nzzz = 1\n", "f.toml:2:1: ecm.zzz: there is no such parameter"},
        Faulty{"youngs_modulus = 1\n",
               "f.toml:1:1: youngs_modulus: there is no such parameter; did you mean ecm.youngs_modulus?"},
        Faulty{"\n[emc]\nradius = 1\nlattice = 2\n", "f.toml:2:2: emc: there is no such section; did you mean ecm?"},
        Faulty{"[[emc]]\n", "f.toml:1:3: emc: there is no such section; did you mean ecm?"},
        Faulty{"ecm = 3", "f.toml:1:1: ecm: is a section; write [ecm] and its keys below, each on a line"},
        Faulty{"[[ecm]]\nradius = 1\n",
               "f.toml:1:3: ecm: is a section; write [ecm] and its keys below, each on a line"},
        Faulty{"[ecm.radius]\nx = 1\n",
               "f.toml:1:1: ecm.radius: is a table, but a number with its unit is expected, such as \"150 um\""}));

INSTANTIATE_TEST_SUITE_P(
    Quantities, OneFault,
    testing::Values(
        Faulty{"[ecm]\nyoungs_modulus = \"200 um\"\n", "f.toml:2:18: ecm.youngs_modulus: \"200 um\" is a length, but a "
                                                       "stress is expected; write it like \"200 Pa\""},
        Faulty{"ecm.viscosity = \"1000 Pa\"", "f.toml:1:17: ecm.viscosity: \"1000 Pa\" is a stress, but a viscosity is "
                                              "expected; write it like \"1000 Pa s\""},
        Faulty{"ecm.youngs_modulus = \"200 Pascal\"",
               "f.toml:1:22: ecm.youngs_modulus: \"200 Pascal\": \"Pascal\" is not a unit; did you mean Pa?"},
        Faulty{"ecm.youngs_modulus = \"200\"", "f.toml:1:22: ecm.youngs_modulus: \"200\" has no unit; write it like "
                                               "\"200 Pa\", or as a bare number in Pa"},
        Faulty{"ecm.youngs_modulus = \"stiff\"",
               "f.toml:1:22: ecm.youngs_modulus: \"stiff\" is not a number with a unit; write it like \"200 Pa\""},
        Faulty{"ecm.youngs_modulus = \"\"",
               "f.toml:1:22: ecm.youngs_modulus: \"\" is not a number with a unit; write it like \"200 Pa\""},
        Faulty{
            "ecm.youngs_modulus = true",
            "f.toml:1:22: ecm.youngs_modulus: is a flag, but a number with its unit is expected, such as \"200 Pa\""},
        Faulty{
            "ecm.youngs_modulus = [200]",
            "f.toml:1:22: ecm.youngs_modulus: is an array, but a number with its unit is expected, such as \"200 Pa\""},
        Faulty{"ecm.youngs_modulus = 2020-01-01", "f.toml:1:22: ecm.youngs_modulus: is a date or time, but a number "
                                                  "with its unit is expected, such as \"200 Pa\""},
        Faulty{"ecm.youngs_modulus = nan", "f.toml:1:22: ecm.youngs_modulus: nan is not a finite number"},
        Faulty{"ecm.youngs_modulus = -inf", "f.toml:1:22: ecm.youngs_modulus: -inf is not a finite number"},
        Faulty{"ecm.youngs_modulus = \"nan Pa\"",
               "f.toml:1:22: ecm.youngs_modulus: \"nan Pa\" is not a number with a unit; write it like \"200 Pa\""}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, OneFault,
    testing::Values(
        Faulty{"ecm.youngs_modulus = 0",
               "f.toml:1:22: ecm.youngs_modulus: 0 Pa is out of range; allowed is > 0 and <= 1e7 Pa"},
        Faulty{"ecm.youngs_modulus = \"11 MPa\"",
               "f.toml:1:22: ecm.youngs_modulus: \"11 MPa\" is out of range; allowed is > 0 and <= 1e7 Pa"},
        Faulty{"ecm.youngs_modulus = \"1e999 Pa\"",
               "f.toml:1:22: ecm.youngs_modulus: \"1e999 Pa\" is out of range; allowed is > 0 and <= 1e7 Pa"},
        Faulty{"ecm.poissons_ratio = 0.5",
               "f.toml:1:22: ecm.poissons_ratio: 0.5 is out of range; allowed is > 0 and < 0.5"},
        Faulty{"ecm.density_min = 1", "f.toml:1:19: ecm.density_min: 1 is out of range; allowed is > 0 and < 1"},
        Faulty{"ecm.density_max = 1", "f.toml:1:19: ecm.density_max: 1 is out of range; allowed is > 1 and <= 10"},
        Faulty{"run.seed = -1", "f.toml:1:12: run.seed: -1 is out of range; allowed is >= 0 and <= 9007199254740991"},
        Faulty{"run.seed = 9007199254740992",
               "f.toml:1:12: run.seed: 9007199254740992 is out of range; allowed is >= 0 and <= 9007199254740991"},
        Faulty{"solver.max_iterations = 4294967297",
               "f.toml:1:25: solver.max_iterations: 4294967297 is out of range; allowed is >= 1 and <= 1e6"}));

INSTANTIATE_TEST_SUITE_P(
    Types, OneFault,
    testing::Values(
        Faulty{"ecm.poissons_ratio = \"0.3\"",
               "f.toml:1:22: ecm.poissons_ratio: is a string; write a bare number without quotes, such as 0.45"},
        Faulty{"run.seed = 1.5",
               "f.toml:1:12: run.seed: has a decimal point or an exponent; write a whole number, such as 1"},
        Faulty{"run.seed = \"7\"",
               "f.toml:1:12: run.seed: is a string; write a whole number without quotes, such as 1"},
        Faulty{"run.seed = true",
               "f.toml:1:12: run.seed: is a flag, but a number without quotes is expected, such as 1"},
        Faulty{"ecm.cell_hole = \"true\"",
               "f.toml:1:17: ecm.cell_hole: is a string; write true or false, without quotes"},
        Faulty{"ecm.cell_hole = 1", "f.toml:1:17: ecm.cell_hole: is a number; write true or false, without quotes"},
        Faulty{"ecm.lattice = 1", "f.toml:1:15: ecm.lattice: is a number; write \"square\" or \"hexagonal\""},
        Faulty{"ecm.lattice = \"hexagon\"",
               "f.toml:1:15: ecm.lattice: \"hexagon\" is not known; allowed is \"square\" or "
               "\"hexagonal\"; did you mean hexagonal?"},
        Faulty{"ecm.lattice = \"Square\"",
               "f.toml:1:15: ecm.lattice: \"Square\" is not known; allowed is \"square\" or "
               "\"hexagonal\"; did you mean square?"}));

INSTANTIATE_TEST_SUITE_P(
    Together, OneFault,
    testing::Values(
        Faulty{"[ecm]\nsmoothing_length = 1\n",
               "f.toml:2:20: ecm.smoothing_length: smoothing length over particle spacing is 0.5; allowed "
               "is 1 to 3: with less "
               "a particle has too few neighbours to carry stress, with more the matrix is smeared out"},
        Faulty{"[ecm]\nparticle_spacing = 5\n",
               "f.toml:2:20: ecm.particle_spacing: smoothing length over particle spacing is 0.52; allowed "
               "is 1 to 3: with less "
               "a particle has too few neighbours to carry stress, with more the matrix is smeared out"},
        Faulty{"ecm.cell_hole = false\necm.radius = 10\necm.particle_spacing=2.6",
               "f.toml:2:14: ecm.radius: a disc of 10 um is clamped throughout: its rim is 2 smoothing lengths "
               "wide; allowed is >= "
               "10.4 um"},
        Faulty{
            "ecm.radius = 20",
            "f.toml:1:14: ecm.radius: the cell and its margin reach 16.9 um from the centre, but the "
            "matrix is clamped from 14.8 um on; take a smaller cell, a start nearer to the centre, or a larger disc"},
        Faulty{"ecm.orphan_support = 0.3", "f.toml:1:22: ecm.orphan_support: ecm.orphan_support is 0.3, "
                                           "but must be below ecm.support_floor, which is 0.3"},
        Faulty{"ecm.support_floor = 0.1", "f.toml:1:21: ecm.support_floor: ecm.orphan_support is 0.2, but "
                                          "must be below ecm.support_floor, which is 0.1"},
        Faulty{"ecm.particle_spacing = 0.1\necm.smoothing_length = 0.13",
               "f.toml:1:24: ecm.particle_spacing: a disc of 150 um at a spacing of 0.1 um has 7.1e+06 "
               "particles; allowed are "
               "4e+06"},
        Faulty{"run.time_step = \"1e-6 s\"",
               "f.toml:1:17: run.time_step: the run takes 2.2e+10 steps; allowed are 1e+09"},
        Faulty{"run.duration = \"0.1 s\"",
               "f.toml:1:16: run.duration: a step of 0.4 s is longer than the run of 0.1 s"}));

TEST(Read, RulesWaitForGoodValues) {
  EXPECT_EQ(faults_of("[ecm]\nsmoothing_length = 1\nparticle_spacing = \"x\"\n").size(), 1u);
}

TEST(Read, EveryFaultIsToldAtOnce) {
  const auto faults = faults_of("[run]\n"
                                "duration = \"6 Pa\"\n"
                                "thread = 3\n"
                                "[emc]\n"
                                "viscosity = 3\n"
                                "[ecm]\n"
                                "youngs_modulus = \"0,2 kPa\"\n"
                                "lattice = \"hexagon\"\n"
                                "density_min = 1.5\n"
                                "[fibres]\n"
                                "half_angle_deg = \"91 deg\"\n",
                                {"cell.radius=3 Pa", "nonsense", "ecm.lattice=round"});
  // NOLINTBEGIN(bugprone-suspicious-missing-comma): messages that are broken over two lines
  const std::vector<std::string> expected{
      "f.toml:2:12: run.duration: \"6 Pa\" is a stress, but a time is expected; write it like \"6 h\"",
      "f.toml:3:1: run.thread: there is no such parameter; did you mean run.threads?",
      "f.toml:4:2: emc: there is no such section; did you mean ecm?",
      "f.toml:7:18: ecm.youngs_modulus: \"0,2 kPa\" has a comma; did you mean \"0.2 kPa\"?",
      "f.toml:8:11: ecm.lattice: \"hexagon\" is not known; allowed is \"square\" or \"hexagonal\"; did you mean "
      "hexagonal?",
      "f.toml:9:15: ecm.density_min: 1.5 is out of range; allowed is > 0 and < 1",
      "f.toml:11:18: fibres.half_angle_deg: \"91 deg\" is out of range; allowed is > 0 and <= 90 deg",
      "--set: cell.radius: \"3 Pa\" is a stress, but a length is expected; write it like \"15 um\"",
      "--set: nonsense: is not of the form key=value",
      "--set: ecm.lattice: \"round\" is not known; allowed is \"square\" or \"hexagonal\""};
  // NOLINTEND(bugprone-suspicious-missing-comma)
  EXPECT_EQ(faults, expected);
}

TEST(Read, TimesInWordsAndSums) {
  const auto seconds = [](const std::string& text) {
    return parse_parameters("run.duration = \"" + text + "\"", "f.toml").run.duration;
  };
  EXPECT_EQ(seconds("1 hour"), 3600.0);
  EXPECT_EQ(seconds("2 hours"), 7200.0);
  EXPECT_EQ(seconds("6 h 30 min"), 23400.0);
  EXPECT_EQ(seconds("6h 30min"), 23400.0);
  EXPECT_EQ(seconds("90 minutes"), 5400.0);
  EXPECT_EQ(seconds("30 seconds"), 30.0);
  EXPECT_EQ(parse_parameters("", "f.toml", {"run.duration=1 hour 30 min"}).run.duration, 5400.0);
  EXPECT_TRUE(same(parse_parameters("run.duration = \"6.5 h\"", "f.toml"),
                   parse_parameters("run.duration = \"6 h 30 min\"", "f.toml")));
}

TEST(Read, AnglesAreBareNumbersOrHaveAUnit) {
  const Parameters p = parse_parameters("fibres.direction_deg = \"30 deg\"\nfibres.half_angle_deg = \"0.5 rad\"\n"
                                        "protrusion.deflection_cone = \"60°\"\n",
                                        "f.toml");
  EXPECT_EQ(p.fibres.direction_deg, 30.0);
  EXPECT_NEAR(p.fibres.half_angle_deg, 28.64788975654116, 1e-13);
  EXPECT_EQ(p.protrusion.deflection_cone, Parameters{}.protrusion.deflection_cone) << "the default is 60 degrees";
  EXPECT_EQ(parse_parameters("protrusion.deflection_cone = \"1.05 rad\"", "f.toml").protrusion.deflection_cone, 1.05);
  EXPECT_EQ(parse_parameters("protrusion.deflection_cone = 1.05", "f.toml").protrusion.deflection_cone, 1.05);
  EXPECT_EQ(parse_parameters("fibres.direction_deg = 45", "f.toml").fibres.direction_deg, 45.0);
  EXPECT_EQ(fault_of("fibres.direction_deg = \"4 rad\""),
            "f.toml:1:24: fibres.direction_deg: \"4 rad\" is out of range; allowed is >= -180 and <= 180 deg");
  EXPECT_EQ(fault_of("fibres.direction_deg = \"4 h\""), "f.toml:1:24: fibres.direction_deg: \"4 h\" is a time, but an "
                                                        "angle is expected; write it like \"30 deg\"");
  EXPECT_EQ(fault_of("ecm.poissons_ratio = \"20 deg\"").substr(0, 45), "f.toml:1:22: ecm.poissons_ratio: is a string;");
}

TEST(Read, AStudyIsNoScenario) {
  EXPECT_EQ(
      fault_of("title = \"x\"\npreset = \"soft\"\nreplicates = 3\n[sweep]\necm.radius = [100, 120]\n"),
      "f.toml: is a study of many runs, and not a scenario; matrigrate study plan f.toml shows what it takes, and "
      "matrigrate study run f.toml computes it");
}

TEST(Read, FurtherRulesBlameThePlaceOfTheirKeys) {
  const std::vector<Rule> more{{"short", {"run.time_step", "ecm.viscosity"}, [](const Parameters& p) {
                                  return p.run.time_step > p.ecm.viscosity ? std::string("too long") : std::string();
                                }}};
  const auto fault = [&](const std::string& text, const std::vector<std::string>& overrides) {
    try {
      parse_parameters(text, "f.toml", overrides, more);
    } catch (const ConfigurationError& error) {
      return std::string(error.what());
    }
    return std::string("good");
  };
  EXPECT_EQ(fault("", {}), "good");
  EXPECT_EQ(fault("[run]\ntime_step = 2\n", {}), "f.toml:2:13: run.time_step: too long");
  EXPECT_EQ(fault("[run]\ntime_step = 0.4\n", {"ecm.viscosity=10 Pa s"}), "--set: ecm.viscosity: too long");
}

TEST(Read, OverridesWinOverTheFile) {
  const Parameters p = parse_parameters("ecm.youngs_modulus = \"50 Pa\"\necm.radius = 100", "f.toml",
                                        {"ecm.youngs_modulus=100 Pa", "ecm.lattice=hexagonal",
                                         "ecm.youngs_modulus=\"400 Pa\"", "run.seed = 12", "ecm.cell_hole=false"});
  EXPECT_EQ(p.ecm.youngs_modulus, 0.4) << "the last one wins";
  EXPECT_EQ(p.ecm.lattice, Lattice::hexagonal);
  EXPECT_EQ(p.run.seed, 12u);
  EXPECT_FALSE(p.ecm.cell_hole);
  EXPECT_EQ(p.ecm.radius, 100.0);
  EXPECT_EQ(apply_overrides(p, {"ecm.radius=120"}).ecm.youngs_modulus, 0.4);
}

struct Override {
  const char* text;
  const char* fault;
};

class BadOverride : public testing::TestWithParam<Override> {};

TEST_P(BadOverride, IsTold) { EXPECT_EQ(fault_of("", {GetParam().text}), GetParam().fault); }

INSTANTIATE_TEST_SUITE_P(
    Table, BadOverride,
    testing::Values(
        Override{"ecm.radius", "--set: ecm.radius: is not of the form key=value"},
        Override{"=3", "--set: is not of the form key=value"}, Override{"", "--set: is not of the form key=value"},
        Override{"ecm.radiu=3", "--set: ecm.radiu: there is no such parameter; did you mean ecm.radius?"},
        Override{"ecm.radius=", "--set: ecm.radius: \"\" is not a number with a unit; write it like \"150 um\""},
        Override{"ecm.radius=nan", "--set: ecm.radius: nan is not a finite number"},
        Override{"ecm.radius=1\nrun.seed=2",
                 "--set: ecm.radius: \"1?run.seed=2\": \"?run.seed=2\" is not a unit; write it like \"150 um\""},
        Override{"ecm.radius=20", "--set: ecm.radius: the cell and its margin reach 16.9 um from the centre, but "
                                  "the matrix is clamped from 14.8 um on; take a smaller cell, a start nearer to the "
                                  "centre, or a larger disc"}));

} // namespace
} // namespace matrigrate
