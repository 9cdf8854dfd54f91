#include "study/conditions.hpp"

#include "unit/study/studies.hpp"

#include <gtest/gtest.h>

namespace matrigrate::study {
namespace {

const std::string two = "[[conditions]]\nlabel = \"soft\"\necm.youngs_modulus = \"50 Pa\"\n[[conditions]]\n"
                        "label = \"one arm\"\nprotrusion.number = 1\n"; // lines 3 to 8

TEST(Conditions, EachFactorSetIsRunAtEachOfThem) {
  const Study s = read(two + "[sweep]\necm.viscosity = [500, 1000]\n");
  ASSERT_EQ(s.points.size(), 4U);
  EXPECT_EQ(s.sets.size(), 2U);
  EXPECT_EQ(s.points_of_set(), 2U);
  EXPECT_EQ(s.points[1].label, "one arm: viscosity 500 Pa s");
  EXPECT_EQ(s.points[s.point_at(1, 0)].label, "soft: viscosity 1000 Pa s");
  EXPECT_EQ(s.points[2].set, 1U);
  EXPECT_EQ(s.points[2].condition, 0U);
  EXPECT_EQ(s.points[2].parameters.ecm.youngs_modulus, 0.05);
  EXPECT_EQ(s.points[2].parameters.ecm.viscosity, 1.0);
  EXPECT_EQ(s.points[3].parameters.protrusion.number, 1);
  EXPECT_EQ(s.points[3].parameters.ecm.youngs_modulus, 0.2);
  EXPECT_EQ(s.points[2].settings,
            (std::vector<Setting>{{"ecm.youngs_modulus", "\"50 Pa\""}, {"ecm.viscosity", "\"1000 Pa s\""}}));
  EXPECT_EQ(read(two).points[0].label, "soft: all") << "with nothing to vary";
  const Study listed = read(two + "[[points]]\nlabel = \"p\"\necm.viscosity = 700\n");
  EXPECT_EQ(listed.points[0].label, "soft: p");
}

TEST(Conditions, AreSettingsLikeOthers) {
  const auto hash = [](const Parameters&) { return std::string(); };
  const auto crossed = planned_runs(read(two + "[sweep]\necm.viscosity = [500]\n"), hash);
  const auto plain = planned_runs(read("[sweep]\necm.viscosity = [500]\necm.youngs_modulus = [50]\n"), hash);
  EXPECT_EQ(crossed[0].seed, plain[0].seed) << "the same run as of a study without conditions";
}

TEST(Conditions, EachFault) {
  EXPECT_EQ(fault_of("conditions = 3\n"),
            "f.toml:3:14: conditions: is no list of conditions; write [[conditions]] and a label and parameters below");
  EXPECT_EQ(fault_of("[[conditions]]\necm.viscosity = 500\n"),
            "f.toml:3:1: conditions.label: is missing; write label = \"soft\", the name for targets");
  EXPECT_EQ(fault_of("[[conditions]]\nlabel = \"\"\n"), "f.toml:4:9: conditions.label: is empty");
  EXPECT_EQ(fault_of(two + "[[conditions]]\nlabel = \"soft\"\n"),
            "f.toml:9:1: conditions: \"soft\" is the label of two conditions");
  EXPECT_EQ(fault_of(two + "[[conditions]]\nlabel = \"mild\"\necm.youngs_modulus = \"0.05 kPa\"\n"),
            "f.toml:9:1: conditions: \"mild\": is the same as another condition");
  EXPECT_TRUE(fault_of("[[conditions]]\nlabel = \"a\"\necm.viscosit = 500\n").ends_with("did you mean ecm.viscosity?"));
  EXPECT_TRUE(fault_of("[[conditions]]\nlabel = \"a\"\necm.radius = \"1 um\"\n")
                  .ends_with("\"1 um\" is out of range; allowed is >= 10 and <= 2000 um"));
  const std::string both = "is also set by the condition \"soft\"; a condition must not set a factor";
  EXPECT_EQ(fault_of(two + "[one_at_a_time]\necm.youngs_modulus = [50]\n"),
            "f.toml:10:22: ecm.youngs_modulus: " + both);
  EXPECT_EQ(fault_of(two + "[morris]\necm.youngs_modulus = [50, 100]\n"), "f.toml:10:22: ecm.youngs_modulus: " + both);
  EXPECT_EQ(fault_of(two + "[[points]]\necm.youngs_modulus = 60\n"), "f.toml:10:22: ecm.youngs_modulus: " + both);
  EXPECT_EQ(
      parse_study("preset = \"baseline\"\nreplicates = 10000\n" + two + "[sweep]\necm.viscosity = [1, 2, 3, 4, 5]\n",
                  "f.toml", ".")
          .runs(),
      100'000U);
  const auto many =
      faults_of("preset = \"baseline\"\nreplicates = 10000\n" + two + "[sweep]\necm.viscosity = [1, 2, 3, 4, 5, 6]\n");
  ASSERT_EQ(many.size(), 1U);
  EXPECT_EQ(many[0], "f.toml:9:1: sweep: makes 6 factor sets; with 2 conditions and 10000 replicates these are 120000 "
                     "runs; allowed are 100000");
  EXPECT_EQ(fault_of("[set]\necm.radius = \"40 um\"\n[[conditions]]\nlabel = \"a\"\nactomyosin.force = 0.5\n"
                     "cell.radius = \"39 um\"\n")
                .substr(0, 7),
            "f.toml:")
      << "rules hold at each condition";
}

TEST(Targets, AreRead) {
  const Study s = read(two
                       + "[[targets]]\nreadout = \"v_migr_abs_um_per_h\"\nvalue = 12.1\nerror = 1\nat = \"one arm\"\n"
                         "[[targets]]\nreadout = \"f_mat\"\nlow = 0.3\nhigh = 0.5\nerror = 0.1\nweight = 2\n");
  ASSERT_EQ(s.targets.size(), 2U);
  EXPECT_EQ(s.targets[0].low, 12.1);
  EXPECT_EQ(s.targets[0].high, 12.1);
  EXPECT_EQ(s.targets[0].at, std::vector<std::size_t>{1});
  EXPECT_TRUE(s.targets[1].at.empty());
  EXPECT_EQ(s.targets[1].weight, 2.0);
  EXPECT_EQ(s.targets[1].high, 0.5);
}

TEST(Targets, EachFault) {
  const auto target = [](const std::string& rest) { return fault_of(two + "[[targets]]\n" + rest); };
  const std::string readout = "readout = \"f_mat\"\n";
  const std::string good = readout + "value = 1\nerror = 1\n";
  EXPECT_TRUE(target("readout = \"f_mats\"\nvalue = 1\nerror = 1\n").starts_with("f.toml:10:11: targets.readout: "));
  EXPECT_TRUE(target("readout = \"f_mats\"\nvalue = 1\nerror = 1\n").ends_with("did you mean f_mat?"));
  EXPECT_EQ(target("value = 1\nerror = 1\n"),
            "f.toml:9:1: targets.readout: is missing; write readout = \"v_migr_abs_um_per_h\"");
  EXPECT_EQ(target(readout + "error = 1\n"),
            "f.toml:9:1: targets.value: is missing; write value = 12.1, or low and high of a range");
  EXPECT_EQ(target(readout + "value = 1\n"),
            "f.toml:9:1: targets.error: is missing; write error = 1.0, the standard error of what was measured");
  EXPECT_EQ(target(readout + "value = 1\nerror = 0\n"),
            "f.toml:12:9: targets.error: 0 is out of range; allowed is > 0");
  EXPECT_EQ(target(readout + "value = \"1\"\nerror = 1\n"),
            "f.toml:11:9: targets.value: is a string, but a number without quotes is expected");
  EXPECT_EQ(target(readout + "value = nan\nerror = 1\n"),
            "f.toml:11:9: targets.value: is not finite, but a number without quotes is expected");
  EXPECT_EQ(target(good + "weight = -1\n"), "f.toml:13:10: targets.weight: -1 is out of range; allowed is > 0");
  EXPECT_EQ(target(readout + "low = 2\nhigh = 2\nerror = 1\n"), "f.toml:11:7: targets.low: 2 is not below high, 2");
  EXPECT_EQ(target(readout + "low = 2\nerror = 1\n"), "f.toml:9:1: targets.high: is missing; a range has low and high");
  EXPECT_EQ(target(good + "low = 2\n"),
            "f.toml:11:9: targets.value: is given together with a range; a target is either a value or a range");
  EXPECT_EQ(target(good + "at = \"sofft\"\n"),
            "f.toml:13:6: targets.at: \"sofft\" is not the label of a condition; the "
            "labels are \"soft\", \"one arm\"; did you mean soft?");
  EXPECT_EQ(target(good + "at = []\n"), "f.toml:13:6: targets.at: is empty; leave it out for all conditions");
  EXPECT_EQ(target(good + "at = [\"soft\", \"soft\"]\n"), "f.toml:13:15: targets.at: \"soft\" is listed twice");
  EXPECT_EQ(target(good + "at = 3\n"),
            "f.toml:13:6: targets.at: is a number, but the label of a condition, or a list of them, is expected");
  EXPECT_EQ(target(good + "eror = 3\n"), "f.toml:13:1: targets.eror: there is no such key; did you mean error?");
  EXPECT_EQ(target(good + "at = \"soft\"\n[[targets]]\n" + good),
            "f.toml:14:1: targets: f_mat has two targets at the same condition");
  EXPECT_EQ(fault_of("[[targets]]\n" + good + "at = \"soft\"\n"),
            "f.toml:7:6: targets.at: \"soft\" is not the label of a condition; the study has no [[conditions]]");
  EXPECT_EQ(fault_of("[targets]\nf_mat = 1\n"),
            "f.toml:3:1: targets: is no list of targets; write [[targets]] and a readout, its value and error below");
  EXPECT_EQ(faults_of("preset = \"baseline\"\nreplicates = 3\n[[targets]]\nvalue = \"1\"\nerror = 0\nat = \"x\"\n"
                      "[morris]\nlevels = 3\nprotrusion.number = [4, 1]\n")
                .size(),
            6U)
      << "all at once";
}

} // namespace
} // namespace matrigrate::study
