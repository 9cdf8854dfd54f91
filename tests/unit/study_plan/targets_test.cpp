#include "study_plan/read_study.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "unit/study_plan/studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include <unistd.h>

#include <filesystem>
#include <string>

namespace matrigrate::study {
namespace {

const std::string two = "[[conditions]]\nlabel = \"soft\"\necm.youngs_modulus = \"50 Pa\"\n[[conditions]]\n"
                        "label = \"one arm\"\nprotrusion.number = 1\n"; // lines 3 to 8

TEST(Conditions, EachFactorSetIsRunAtEachOfThem) {
  const Study s = read(two + "[sweep]\necm.viscosity = [500, 1000]\n");
  ASSERT_EQ(s.points.size(), 4U);
  EXPECT_EQ(s.sets.size(), 2U);
  EXPECT_EQ(s.points[1].label, "one arm: viscosity 500 Pa s");
  EXPECT_EQ(s.points[2].label, "soft: viscosity 1000 Pa s");
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
  EXPECT_EQ(fault_of(two + "[sweep]\necm.youngs_modulus = [50]\n"), "f.toml:10:22: ecm.youngs_modulus: " + both);
  EXPECT_EQ(fault_of(two + "[latin_hypercube]\nsamples = 2\necm.youngs_modulus = [50, 100]\n"),
            "f.toml:11:22: ecm.youngs_modulus: " + both);
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
  EXPECT_TRUE(target("readout = \"f_mats\"\nvalue = 1\nerror = 1\n").find("did you mean f_mat? `")
              != std::string::npos);
  EXPECT_EQ(target("value = 1\nerror = 1\n"),
            "f.toml:9:1: targets.readout: is missing; write readout = \"v_migr_abs_um_per_h\"");
  EXPECT_EQ(target(readout + "error = 1\n"),
            "f.toml:9:1: targets.value: is missing; write value = 12.1, or low and high of a range");
  EXPECT_EQ(target(readout + "value = 1\n"),
            "f.toml:9:1: targets.error: is missing; write error = 1.0, the standard error of what was measured");
  EXPECT_EQ(target(readout + "value = 1\nerror = 0\n"),
            "f.toml:12:9: targets.error: 0 is out of range; allowed are 1e-30 to 1e+30");
  EXPECT_EQ(target(readout + "value = \"1\"\nerror = 1\n"),
            "f.toml:11:9: targets.value: is a string, but a number without quotes is expected");
  EXPECT_EQ(target(readout + "value = nan\nerror = 1\n"),
            "f.toml:11:9: targets.value: is not finite, but a number without quotes is expected");
  EXPECT_EQ(target(good + "weight = -1\n"),
            "f.toml:13:10: targets.weight: -1 is out of range; allowed are 1e-30 to 1e+30");
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
                      "[latin_hypercube]\nsamples = 0\nprotrusion.number = [4, 1]\n")
                .size(),
            6U)
      << "all at once";
}

/// A file of tracks, and a study with it as a target.
class MeasuredTracks : public testing::Test {
protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() / ("matrigrate-measured-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  Study study_of(const std::string& tracks, const std::string& target) const {
    write_file(folder / "c.csv", tracks);
    return parse_study("preset = \"baseline\"\nreplicates = 3\n[[points]]\nlabel = \"a\"\n[[targets]]\n" + target,
                       "f.toml", folder);
  }

  std::string faults(const std::string& tracks, const std::string& target = speed + file) const {
    try {
      study_of(tracks, target);
    } catch (const ConfigurationError& error) {
      std::string text = error.what();
      for (std::size_t at = 0; (at = text.find(folder.string() + "/")) != std::string::npos;)
        text.erase(at, folder.string().size() + 1);
      return text;
    }
    return "none";
  }

  inline static const std::string speed = "readout = \"v_migr_path_600s_um_per_h\"\n";
  inline static const std::string file = "tracks = \"c.csv\"\n";
  inline static const std::string head = "track,t_s,x_um,y_um\n";
  std::filesystem::path folder;
};

TEST_F(MeasuredTracks, AreMeanAndStandardErrorOverTracks) {
  // 5 um and 15 um in 10 minutes: 30 and 90 um/h; the second track begins late, and rows are mixed.
  const Study s = study_of(head + "a,0,0,0\nb,1200,1,1\na,600,3,4\nb,1800,10,13\n", speed + file + "weight = 2\n");
  ASSERT_EQ(s.targets.size(), 1U);
  EXPECT_DOUBLE_EQ(s.targets[0].low, 60.0);
  EXPECT_EQ(s.targets[0].low, s.targets[0].high);
  EXPECT_DOUBLE_EQ(s.targets[0].error, 30.0);
  EXPECT_EQ(s.targets[0].weight, 2.0);
  // The study in its folder names a file of its own, which has the same tracks.
  EXPECT_NE(to_toml(s, "x.toml").find("tracks = \"measured-1.csv\""), std::string::npos);
  const std::string written = tracks::measured_csv(*s.targets[0].tracks);
  EXPECT_EQ(written, head + "1,0,0,0\n1,600,3,4\n2,0,1,1\n2,600,10,13\n");
  EXPECT_EQ(study_of(written, speed + file).targets[0].low, s.targets[0].low);
  // Columns in any order, further ones, ends of lines of other systems.
  EXPECT_EQ(study_of("y_um,q,x_um,t_s,track\r\n0,,0,0,1\r\n4,,3,600,1\r\n0,,0,0,2\r\n12,,9,600,2\r\n", speed + file)
                .targets[0]
                .low,
            60.0);
}

TEST_F(MeasuredTracks, OfAnyReadoutOfAPath) {
  std::string tracks = head;
  for (const int cell : {1, 2})
    for (int k = 0; k <= 60; ++k)
      tracks += std::to_string(cell) + "," + std::to_string(60 * k) + "," + std::to_string(cell * k) + ",0\n";
  const auto value = [&](const std::string& readout) {
    return study_of(tracks, "readout = \"" + readout + "\"\n" + file).targets[0].low;
  };
  for (const std::string name : {"v_migr_abs_um_per_h", "v_migr_path_60s_um_per_h", "v_migr_path_600s_um_per_h"})
    EXPECT_NEAR(value(name), 90.0, 1e-9) << name;
  EXPECT_EQ(faults(tracks, "readout = \"msd_slope\"\n" + file).find("f.toml:"), 0U) << "2 of both: the same";
}

TEST_F(MeasuredTracks, OfOtherProgramsAreReadByKeys) {
  const std::string table =
      "Track n\u00b0\tSlice n\u00b0\tX\tY\n1\t1\t0\t0\n1\t2\t6\t8\n2\t1\t0\t0\n2\t2\t18\t24\n3\t1\t0\t0\n";
  const Study s = study_of(table, speed + file + "pixel = \"500 nm\"\ninterval = \"10 min\"\n");
  EXPECT_DOUBLE_EQ(s.targets[0].low, 60.0);
  EXPECT_EQ(s.targets[0].notes, std::vector<std::string>{"1 track of fewer than 2 positions is left out"});
  // The copy in the folder of the study needs no keys.
  EXPECT_EQ(to_toml(s, "x.toml").find("pixel"), std::string::npos);
  const std::string named = "A;B;C;D\n1;0;0;0\n1;600;3;4\n2;0;0;0\n2;600;9;12\n";
  EXPECT_DOUBLE_EQ(
      study_of(named,
               speed + file
                   + "pixel = 1\ntime_unit = \"s\"\ncolumns = {track = \"A\", t = \"B\", x = \"C\", y = \"D\"}\n")
          .targets[0]
          .low,
      60.0);
  EXPECT_EQ(faults(table, speed + file + "pixel = \"5 s\"\ninterval = 0\n"),
            "f.toml:8:9: targets.pixel: \"5 s\": is a time; write it in um\n"
            "f.toml:9:12: targets.interval: 0 is out of range; allowed are numbers above 0 up to 1e9");
}

TEST_F(MeasuredTracks, OfTwoMoviesAreRefusedButInTheCopyOfAStudy) {
  std::string glued = head;
  for (int cell = 1; cell <= 2; ++cell)
    for (int k = 0; k < 12; ++k)
      glued += fmt::format("{},{},{},{}\n", cell, 600 * k, cell * k + (k > 5 ? 100 : 0), k > 5 ? cell * 200 : 0);
  EXPECT_NE(faults(glued).find("another movie begins. Tell movies apart by a column, columns = \"group=NAME\""),
            std::string::npos)
      << faults(glued);
  const Study s = study_of(glued, speed + file + "columns = {group = \"none\"}\n");
  write_file(folder / "measured-1.csv", tracks::measured_csv(*s.targets[0].tracks));
  EXPECT_EQ(study_of(glued, speed + "tracks = \"measured-1.csv\"\n").targets[0].low, s.targets[0].low);
}

TEST_F(MeasuredTracks, EachFaultHasItsLine) {
  const std::string good = "1,0,0,0\n1,600,3,4\n2,0,0,0\n2,600,9,12\n";
  EXPECT_EQ(faults(head + good), "none");
  EXPECT_EQ(faults("track,t,x_um,y_um\n1,0,0,0\n1,9,1,1\n"),
            "c.csv: does not state the unit of t: give time_unit = \"s\" (or min)");
  EXPECT_EQ(faults(head + "1,0,0,0\n1,600,inf,4\n1,x,3,4\n"),
            "c.csv:3:1: x_um: \"inf\" is no finite number\nc.csv:4:1: t_s: \"x\" is no finite number");
  EXPECT_EQ(faults(head + "1,0,0\n"), "c.csv:2:1: has 3 fields, the header 4");
  EXPECT_EQ(faults(head + "1,0,0,0\n1,600,3,4\n"),
            "c.csv: has 1 track of at least 2 positions; 2 are needed to tell how "
            "cells differ (shortest, fewest)");
  EXPECT_EQ(faults(head + good + "2,1800,3,4\n"), "c.csv: 1 of 2 tracks have gaps (2); a target needs tracks without");
  EXPECT_EQ(
      faults(head + good + "2,900,3,4\n"),
      "c.csv:6:1: track 2 has a step of 300 s, most have 600 s: one interval is needed, within 10 % (jitter = 0.1)");
  EXPECT_EQ(faults(head + "1,0,0,0\n1,600,3,4\n2,0,0,0\n2,600,3,4\n"),
            "f.toml:7:10: targets.tracks: all tracks of \"c.csv\" have the same v_migr_path_600s_um_per_h");
  EXPECT_EQ(
      faults(head + "1,0,0,0\n1,60,3,4\n2,0,0,0\n2,60,9,12\n"),
      "f.toml:7:10: targets.tracks: 0 of 2 tracks of \"c.csv\" have a v_migr_path_600s_um_per_h: it may need longer "
      "tracks or a shorter interval");
  EXPECT_EQ(faults(head + good, "readout = \"f_mat\"\n" + file),
            "f.toml:7:10: targets.tracks: tell no f_mat; they tell v_migr_abs_um_per_h, v_migr_path_60s_um_per_h, "
            "v_migr_path_600s_um_per_h, msd_slope");
  EXPECT_EQ(faults(head + good, speed + file + "value = 3\nerror = 1\n"),
            "f.toml:8:9: targets.value: stands beside tracks, which tell it\n"
            "f.toml:9:9: targets.error: stands beside tracks, which tell it");
  EXPECT_EQ(faults(head + good, speed + "value = 3\nerror = 1\ninterval = 5\n"),
            "f.toml:9:12: targets.interval: tells how tracks are read; there are none: write tracks = \"FILE\"");
  const std::string missing = faults(head + good, speed + "tracks = \"d.csv\"\n");
  EXPECT_EQ(missing.find("f.toml:7:10: targets.tracks: d.csv: "), 0U) << missing;
}

TEST_F(MeasuredTracks, ThoseOfARunAreTheRowsOfItsCells) {
  const std::filesystem::path table = folder / "tracks.csv";
  write_file(table, "track,t_s,x_um,y_um\n1,0,0,1\n2,0,5,6\n1,60,2,3\n");
  const std::vector<tracks::CellTrack> tracks = tracks::cell_tracks(folder);
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(tracks[0].x, (std::vector<double>{0.0, 2.0}));
  EXPECT_EQ(tracks[1].cell, 2U);
  for (const char* wrong : {"track,t_s,x_um,y_um\n1.5,0,0,1\n", "track,t_s,x_um,y_um\n0,0,0,1\n",
                            "track,t_s,x_um,y_um\n,0,0,1\n", "t_s,x_um\n0,0\n", "x_um,y_um\n0,0\n"}) {
    write_file(table, wrong);
    EXPECT_THROW(tracks::cell_tracks(folder), InputOutputError) << wrong;
  }
}

TEST(Distance, IsInErrorsOfTheTargetAndARootMeanSquareOverTargets) {
  const Target value{.readout = "f_mat", .low = 10.0, .high = 10.0, .error = 2.0, .weight = 1.0, .at = {}};
  EXPECT_EQ(distance(value, 13.0), 1.5);
  EXPECT_EQ(distance(value, 4.0), -3.0) << "with its sign";
  Target range = value;
  range.high = 14.0;
  range.weight = 3.0;
  EXPECT_EQ(distance(range, 12.0), 0.0) << "inside";
  EXPECT_EQ(distance(range, 15.0), 0.5) << "from the nearer end";
  EXPECT_DOUBLE_EQ(distance({value, range}, {2.0, -1.0}), std::sqrt((4.0 + 3.0) / 4.0));
  EXPECT_TRUE(std::isnan(distance({value, range}, {2.0, std::nan("")})));
}

} // namespace
} // namespace matrigrate::study
