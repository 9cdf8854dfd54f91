#include "parameters/version.hpp"
#include "program.hpp"
#include "store/checkpoint.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

/// What other versions of the program have computed is found, gone on with, and never lost.
namespace matrigrate {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

const std::string other_name = "0123456789abcdef"; // of a run, as this program does not call it

class OtherVersion : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"0.002 h\"\n[output]\ntrack_interval = \"2 s\"\n"
                    "pictures = false\n");
    write_study(2);
  }

  void write_study(int replicates) const {
    write("e.toml", "scenario = \"s.toml\"\nreplicates = " + std::to_string(replicates)
                        + "\nreadouts = [\"v_migr_abs_um_per_h\"]\n[sweep]\necm.youngs_modulus = [\"50 Pa\", \"100 "
                          "Pa\"]\n");
  }

  std::string file(const std::string& name) const { return text_of(folder / name); }

  /// Names of the runs of a study.
  std::vector<std::string> names(const std::string& study = "e-study") const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder / study / "runs"))
      if (entry.is_directory()) all.push_back(entry.path().filename());
    std::ranges::sort(all);
    return all;
  }

  std::string path(const std::string& name) const { return "e-study/runs/" + name; }

  std::string trajectory(const std::string& run) const {
    return json::parse(file(run + "/run.json")).at("trajectory_hash");
  }

  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = file(name);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << ": " << from;
    text.replace(at, from.size(), to);
    write(name, text);
  }

  /// Calls a run as a version would whose fingerprints are others, and which does not have all of today's parameters.
  void rename(const std::string& name) const {
    fs::rename(folder / path(name), folder / path(other_name));
    change(path(other_name) + "/run.json", "\"configuration_hash\": \"" + name,
           "\"configuration_hash\": \"" + other_name);
    change(path(other_name) + "/scenario.resolved.toml", "\nspread = 1\n", "\n");
    change(path(other_name) + "/scenario.resolved.toml", "\nreport = true\n",
           "\nreport = true\npictures = false\nsnapshot_interval = \"2 s\"\n");
    change(path(other_name) + "/scenario.resolved.toml", fmt::format("version = \"{}\"\n", this_version),
           "version = \"0.1.9\"\n");
  }
};

/// A table of version 0.2.0, whose fields hold no commas, with the read-outs that came later, which its runs lack.
std::string with_later_columns(const std::string& table) {
  const std::string names =
      ",step_angle_deg,net_angle_deg,along_over_across_1h,along_over_across_3h,along_over_across_6h";
  std::string wide;
  std::istringstream lines(table);
  std::size_t before = 0; // fields
  for (std::string line; std::getline(lines, line);) {
    if (wide.empty())
      before = static_cast<std::size_t>(std::count(
                   line.begin(), line.begin() + static_cast<std::ptrdiff_t>(line.find(",parting_index")), ','))
               + 1;
    std::size_t at = 0;
    for (std::size_t k = 0; k < before; ++k) at = line.find(',', at) + 1;
    wide += line.substr(0, at - 1) + (wide.empty() ? names : ",,,,,") + line.substr(at - 1) + "\n";
  }
  return wide;
}

TEST_F(OtherVersion, AStudyOfVersion020IsKnown) {
  const fs::path made = MATRIGRATE_WRITTEN_BY_020;
  fs::copy(made, folder / "old", fs::copy_options::recursive);
  EXPECT_TRUE(contains(run("study status old").out, "2 runs: 2 done"));
  const Ended collected = run("study collect old");
  EXPECT_EQ(collected.code, 0) << collected.err;
  EXPECT_EQ(file("old/results.csv"), with_later_columns(text_of(made / "results.csv")));
  const Ended again = run("study run old/study.resolved.toml --jobs 1");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.out, "2 of 2 runs done, 0 of them now")) << again.out;
  EXPECT_EQ(names("old").size(), 2U);
}

/// What was made is read; nothing more is made of a reading that has gone, nor is one taken for another.
TEST_F(OtherVersion, AStudyOfAReadingThatHasGoneIsReadButNotComputed) {
  fs::copy(MATRIGRATE_WRITTEN_BY_020, folder / "old", fs::copy_options::recursive);
  const std::string held = file("old/scenario.resolved.toml");
  for (const char* scenario : {"old/scenario.resolved.toml", "old/runs/54d260625a6d7c23/scenario.resolved.toml",
                               "old/runs/efc7f10c11a93980/scenario.resolved.toml"})
    change(scenario, "\nhold = \"matter\"\n", "\nhold = \"place\"\n");
  const std::string of_place = file("old/scenario.resolved.toml");
  EXPECT_TRUE(contains(run("study status old").out, "2 runs: 2 done"));
  const Ended collected = run("study collect old");
  EXPECT_EQ(collected.code, 0) << collected.err;
  EXPECT_TRUE(contains(collected.out, "2 of 2 runs done"));
  const Ended refused = run("study run old/study.resolved.toml");
  EXPECT_EQ(refused.code, 3);
  EXPECT_TRUE(contains(refused.err, "adhesion.hold: \"place\" has gone: an adhesion holds the matter")) << refused.err;
  EXPECT_TRUE(contains(refused.err, "the version of the tag closures-2")) << refused.err;
  write("matter.toml", held);
  write("own.toml", "scenario = \"matter.toml\"\nreplicates = 2\nseed = 1\n");
  const Ended other = run("study run own.toml -o old");
  EXPECT_EQ(other.code, 5) << other.out;
  EXPECT_TRUE(contains(other.err, "adhesion.hold: place there, matter here")) << other.err;
  EXPECT_EQ(file("old/scenario.resolved.toml"), of_place);
}

TEST_F(OtherVersion, AStudyThatAddsNothingKeepsTheFilesOfWhoeverWroteThem) {
  fs::copy(MATRIGRATE_WRITTEN_BY_020, folder / "old", fs::copy_options::recursive);
  const std::string scenario = file("old/scenario.resolved.toml");
  const std::string study = file("old/study.resolved.toml");
  const Ended again = run("study run old/study.resolved.toml -o old --jobs 1");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "was written by matrigrate 0.2.0")) << again.err;
  EXPECT_EQ(file("old/scenario.resolved.toml"), scenario);
  EXPECT_EQ(file("old/study.resolved.toml"), study);
}

TEST_F(OtherVersion, AMixedStudySaysSoWhereItsStatusIsAsked) {
  fs::copy(MATRIGRATE_WRITTEN_BY_020, folder / "old", fs::copy_options::recursive);
  EXPECT_FALSE(contains(run("study status old").out, "builds of matrigrate"));
  fs::remove_all(folder / "old/runs/54d260625a6d7c23");
  ASSERT_EQ(run("study run old/study.resolved.toml --jobs 1").code, 0);
  const Ended status = run("study status old");
  EXPECT_TRUE(contains(status.out, "2 runs: 2 done")) << status.out;
  EXPECT_TRUE(contains(status.out, "made by 2 builds of matrigrate: 0.2.0 (")) << status.out;
  EXPECT_TRUE(contains(status.out, "They do not belong together: the model has changed since 0.2.0")) << status.out;
  EXPECT_EQ(json::parse(run("study status old --json").out).at("builds").size(), 2U);
}

/// A run that version 0.2.0 is said to have made, whose checkpoints come every 24 s and are kept each minute.
class RunOfVersion020 : public OtherVersion {
protected:
  void SetUp() override {
    OtherVersion::SetUp();
    write("r.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"96 s\"\n[output]\ntrack_interval = \"12 s\"\n"
                    "checkpoint_interval = \"24 s\"\nkept_checkpoint_interval = \"60 s\"\npictures = false\n");
    ASSERT_EQ(run("run r.toml -o old --quiet").code, 0);
  }

  /// A scenario as version 0.2.0 wrote it.
  /// @param setting  further lines of section [adhesion] ... as "section", "line"; none: empty
  static std::string of_version_020(std::string text, const std::string& section, const std::string& line) {
    const auto replace = [&text](const std::string& from, const std::string& to) {
      const std::size_t at = text.find(from);
      ASSERT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), to);
    };
    replace(fmt::format("version = \"{}\"\n", this_version), "");
    for (const char* law : {"curvature_factor", "initiation_bias"}) {
      const std::size_t at = text.find(std::string("\n") + law + " = ");
      text.erase(at, text.find('\n', at + 1) - at);
    }
    if (!section.empty()) replace("\n[" + section + "]\n", "\n[" + section + "]\n" + line + "\n");
    for (const auto& [name, left] :
         {std::pair("cell", "centre_of_mass = \"particles\""), {"adhesion", "hold = \"matter\""}})
      if (line.find(std::string(left).substr(0, 6)) == std::string::npos)
        replace(fmt::format("\n[{}]\n", name), fmt::format("\n[{}]\n{}\n", name, left));
    return text;
  }

  void make_old(const std::string& section = "", const std::string& line = "") const {
    std::vector<fs::path> checkpoints{"checkpoint.h5", "checkpoint_prev.h5"};
    for (const auto& entry : fs::directory_iterator(folder / "old/checkpoints"))
      checkpoints.push_back("checkpoints" / entry.path().filename());
    for (const fs::path& name : checkpoints) {
      store::Checkpoint checkpoint = store::read_checkpoint(folder / "old" / name);
      checkpoint.program = "matrigrate 0.2.0 (9a32bbbb)";
      checkpoint.scenario = of_version_020(checkpoint.scenario, section, line);
      checkpoint.configuration_hash = other_name;
      std::ofstream(folder / "old" / name, std::ios::binary) << store::checkpoint_image(checkpoint);
    }
    write("old/scenario.resolved.toml", of_version_020(file("old/scenario.resolved.toml"), section, line));
    json record = json::parse(file("old/run.json"));
    record["version"] = "0.2.0";
    record["git_hash"] = "9a32bbbb";
    record["git_dirty"] = false;
    record["configuration_hash"] = other_name;
    for (const char* key : {"closures", "scenario_version"}) record.erase(key);
    write("old/run.json", record.dump());
  }

  std::string tracks(const std::string& of) const { return file(of + "/tracks.csv"); }
};

TEST_F(RunOfVersion020, ABranchThatWouldComputeItsPastAnewIsRefused) {
  make_old();
  const Ended early = run("resume old --at '30 s' --set ecm.youngs_modulus='50 Pa' -o early");
  EXPECT_EQ(early.code, 3) << early.err;
  EXPECT_TRUE(contains(early.err, "--at: old has no checkpoint at 30 s or before")) << early.err;
  EXPECT_TRUE(contains(early.err, "matrigrate 0.2.0 (9a32bbbb) computed it, and the model has changed since 0.2.0"))
      << early.err;
  EXPECT_TRUE(contains(early.err, "--at \"60 s\" or later begins from a checkpoint")) << early.err;
  EXPECT_FALSE(fs::exists(folder / "early"));
  const Ended later = run("resume old --at '60 s' --set ecm.youngs_modulus='50 Pa' -o later --quiet");
  EXPECT_EQ(later.code, 0) << later.err;
  EXPECT_TRUE(contains(later.err, "From 1 min on another model computes: the model has changed since 0.2.0"))
      << later.err;
  EXPECT_EQ(json::parse(file("later/run.json")).at("scenario_version"), "0.2.0");
}

/// By the records of those who computed it, however it was named since.
TEST_F(RunOfVersion020, APastOfAnotherModelIsKnownAfterItWasResumed) {
  make_old();
  json record = json::parse(file("old/run.json"));
  record["lineage"] = {{{"event", "resumed"}, {"written_by", "matrigrate 0.2.0 (9a32bbbb)"}, {"t_s", 60.0}}};
  record["version"] = this_version;
  write("old/run.json", record.dump());
  for (const char* name : {"old/checkpoint.h5", "old/checkpoint_prev.h5", "old/checkpoints"})
    fs::remove_all(folder / name);
  const Ended refused = run("resume old --at '30 s' --seed 2 -o early");
  EXPECT_EQ(refused.code, 3) << refused.err;
  EXPECT_TRUE(contains(refused.err, "No later checkpoint is left")) << refused.err;
}

TEST_F(RunOfVersion020, ABranchOfAnotherBuildSaysThatItsPastIsComputedAnew) {
  json record = json::parse(file("old/run.json"));
  record["git_hash"] = "ffffffff";
  write("old/run.json", record.dump());
  const Ended ended = run("resume old --at '30 s' --seed 2 -o early --quiet");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.err, "its past, computed by matrigrate")) << ended.err;
  const json lineage = json::parse(file("early/run.json")).at("lineage").back();
  EXPECT_TRUE(lineage.at("checkpoint").is_null());
  EXPECT_TRUE(contains(lineage.at("written_by"), "(ffffffff"));
  ASSERT_EQ(run("run r.toml -o own --quiet").code, 0);
  EXPECT_EQ(run("resume own --at '30 s' --seed 2 -o own-early --quiet").err, "") << "of this build nothing is said";
}

TEST_F(RunOfVersion020, ItsScenarioSaysThatTheModelIsAnother) {
  make_old();
  const std::string note = "was written by matrigrate 0.2.0, of whose runs this program repeats no bits: the model has "
                           "changed since 0.2.0";
  EXPECT_TRUE(contains(run("check old/scenario.resolved.toml").out, note));
  EXPECT_TRUE(contains(run("explain old/scenario.resolved.toml").out, note));
  EXPECT_TRUE(contains(run("run old/scenario.resolved.toml -o again --quiet").err, note));
  const json record = json::parse(file("again/run.json"));
  EXPECT_EQ(record.at("scenario_version"), "0.2.0");
  EXPECT_TRUE(contains(file("again/report.html"), "scenario written by"));
  EXPECT_FALSE(json::parse(file("old/run.json")).contains("scenario_version"));
  ASSERT_EQ(run("run r.toml -o own --quiet").code, 0);
  EXPECT_TRUE(json::parse(file("own/run.json")).at("scenario_version").is_null());
}

TEST_F(RunOfVersion020, ItIsShownWhateverReadingsItHas) {
  const std::string own_tracks = tracks("old");
  for (const auto& [section, line] : {std::pair("adhesion", "hold = \"place\""),
                                      {"cell", "centre_of_mass = \"area\""},
                                      {"polarization", "turning = \"constant\""},
                                      {"ecm", "formulation = \"updated_lagrangian\""},
                                      {"fibres", "plane_to_space = true"}}) {
    fs::remove_all(folder / "old");
    ASSERT_EQ(run("run r.toml -o old --quiet").code, 0);
    make_old(section, line);
    EXPECT_EQ(run("report old").code, 0) << line << run("report old").err;
    EXPECT_TRUE(contains(file("old/report.html"), "a reading that has gone")) << line;
    EXPECT_EQ(run("export old --tracks").code, 0) << line;
    EXPECT_EQ(run("diff old old").code, 0) << line;
    EXPECT_TRUE(contains(run("resume old").out, "done already")) << line;
    for (const char* compute : {"resume old --hours 1 -o longer", "run old/scenario.resolved.toml -o new",
                                "check old/scenario.resolved.toml", "explain old/scenario.resolved.toml"}) {
      const Ended refused = run(compute);
      EXPECT_EQ(refused.code, 3) << compute << refused.err;
      EXPECT_TRUE(contains(refused.err, "has gone: ")) << refused.err;
    }
    EXPECT_FALSE(fs::exists(folder / "longer") || fs::exists(folder / "new"));
    EXPECT_EQ(tracks("old"), own_tracks);
  }
}

TEST_F(RunOfVersion020, WhatALawSaysNowGoesOn) {
  make_old("actomyosin", "curvature_profile = \"triangle\"");
  EXPECT_EQ(run("report old").code, 0);
  EXPECT_TRUE(contains(file("old/report.html"), "max(0, 1 - abs(kappa - kappa_0)/kappa_w)"));
  const Ended longer = run("resume old --hours 0.04 -o longer --quiet");
  EXPECT_EQ(longer.code, 0) << longer.err;
  EXPECT_TRUE(contains(file("longer/scenario.resolved.toml"),
                       "curvature_factor = \"max(0, 1 - abs(kappa - kappa_0)/kappa_w)\""));
}

/// Names and seeds are those of a program that took a law for its text.
TEST_F(OtherVersion, RunsOfALawAsItWasTypedAreFound) {
  const std::string law = "r_c*exp( -F/F_c)";
  const std::vector<std::string> constants{"r_c = 0.2 1/s, F_c = 50 pN", "r_c = 0.2 1/s, F_c=60 pN"};
  write("e.toml", "scenario = \"s.toml\"\nreplicates = 1\nreadouts = [\"v_migr_abs_um_per_h\"]\n[set]\n"
                  "laws.disassembly_rate = \""
                      + law + "\"\n[sweep]\nlaws.constants = [\"" + constants[0] + "\", \"" + constants[1] + "\"]\n");
  fs::create_directories(folder / "e-study/runs");
  const auto make = [&](const std::string& name, const std::string& seed, const std::string& given) {
    const Ended ended = run("run s.toml --quiet --set 'laws.disassembly_rate=" + law
                            + "' --set 'laws.constants=" + given + "' --seed " + seed + " -o " + path(name));
    EXPECT_EQ(ended.code, 0) << ended.err;
  };
  make("871a728be6fb8d25", "7737665334164416", constants[0]);
  make("32cc548fb21516be", "1798389745098024", constants[1]);
  const Ended again = run("study run e.toml --jobs 1");
  EXPECT_TRUE(contains(again.out, "2 of 2 runs done, 0 of them now")) << again.out << again.err;
  EXPECT_EQ(names(), (std::vector<std::string>{"32cc548fb21516be", "871a728be6fb8d25"}));
  EXPECT_TRUE(contains(file("e-study/results.csv"), ",7737665334164416,done,")) << file("e-study/results.csv");
  const Ended status = run("study status e-study"); // whose base names constants that only its points give
  EXPECT_TRUE(contains(status.out, "2 runs: 2 done")) << status.err;
}

TEST_F(OtherVersion, RunsOfSeveralBuildsAreTold) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  EXPECT_FALSE(contains(run("study collect e-study").out, "builds of matrigrate"));
  change(path(names().front()) + "/run.json", "\"git_hash\": \"", "\"git_hash\": \"ffffffff");
  EXPECT_TRUE(contains(run("study collect e-study").out, "these runs were made by 2 builds of matrigrate: "));
  EXPECT_TRUE(contains(run("study run e.toml").out, "these runs were made by 2 builds of matrigrate: "));
}

TEST_F(OtherVersion, ARunOfAnotherNameIsKnownByItsScenario) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  const std::string table = file("e-study/results.csv");
  const std::string name = names().front();
  rename(name);
  EXPECT_TRUE(contains(run("study status e-study").out, "4 runs: 4 done"));
  EXPECT_EQ(run("study collect e-study").code, 0);
  std::string renamed = table;
  renamed.replace(renamed.find(name), name.size(), other_name);
  EXPECT_EQ(file("e-study/results.csv"), renamed) << "the table names the folder";
  const Ended again = run("study run e.toml --jobs 2");
  EXPECT_TRUE(contains(again.out, "4 of 4 runs done, 0 of them now")) << again.out << again.err;
  EXPECT_EQ(names().size(), 4U);
}

TEST_F(OtherVersion, AStoppedRunOfAnotherNameGoesOnToTheSameBits) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  const std::string name = names().front();
  const std::string hash = trajectory(path(name));
  fs::rename(folder / path(name) / "checkpoint_prev.h5", folder / path(name) / "checkpoint.h5");
  change(path(name) + "/run.json", "\"status\": \"done\"", "\"status\": \"interrupted\"");
  rename(name);
  const Ended again = run("study run e.toml --jobs 1");
  EXPECT_TRUE(contains(again.out, "4 of 4 runs done, 1 of them now")) << again.out << again.err;
  EXPECT_EQ(trajectory(path(other_name)), hash);
  EXPECT_EQ(json::parse(file(path(other_name) + "/run.json")).at("lineage").size(), 1U) << "resumed, not begun anew";
  EXPECT_EQ(names().size(), 4U);
}

TEST_F(OtherVersion, ARunWhoseRecordHasAnotherFingerprintIsTheSameIfItsParametersAre) {
  ASSERT_EQ(run("run s.toml -o one").code, 0);
  const std::string hash = trajectory("one");
  json record = json::parse(file("one/run.json"));
  record["configuration_hash"] = other_name;
  write("one/run.json", record.dump());
  EXPECT_EQ(run("run s.toml -o one").code, 0);
  EXPECT_EQ(json::parse(file("one/run.json")), record) << "a run that is done is left as it is";
  EXPECT_EQ(run("run s.toml -o one --set cell.dashpot='0.003 N s/m'").code, 5);
}

TEST_F(OtherVersion, ATableIsNotReplacedByOneWithFewerRuns) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  const std::string table = file("e-study/results.csv");
  const std::string name = names().front();
  fs::rename(folder / path(name), folder / "archive");
  for (const char* verb : {"study collect", "report"}) {
    const std::string page = file("e-study/report.html");
    const Ended refused = run(std::string(verb) + " e-study");
    EXPECT_EQ(refused.code, 5) << verb;
    EXPECT_TRUE(contains(
        refused.err, "e-study/results.csv: is kept as it is: it holds results of runs that are not done here any more"))
        << refused.err;
    EXPECT_TRUE(contains(refused.err, "(runs/" + name + ")")) << refused.err;
    EXPECT_EQ(file("e-study/results.csv"), table);
    EXPECT_EQ(file("e-study/report.html"), page);
  }
  const Ended again = run("study run e.toml --jobs 1");
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(contains(again.err, "these runs were done and are not any more; they are computed again")) << again.err;
  EXPECT_EQ(file("e-study/results.csv"), table);
}

TEST_F(OtherVersion, ATableThatWasMovedAwayIsMadeAnew) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  fs::remove_all(folder / path(names().front()));
  fs::rename(folder / "e-study/results.csv", folder / "results-of-all.csv");
  EXPECT_EQ(run("study collect e-study").code, 0);
  EXPECT_TRUE(contains(file("e-study/results.csv"), ",missing,"));
}

/// Damages files of one finished run: gone, no table or JSON at all, cut.
TEST_F(OtherVersion, OneDamagedRunDoesNotStopAStudy) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  const std::string table = file("e-study/results.csv");
  const std::string name = names().front();
  fs::copy(folder / "e-study", folder / "whole", fs::copy_options::recursive);
  const auto rows_but = [&](std::string text) { // of the damaged run
    const std::size_t at = text.find("\n" + name) + 1;
    return text.erase(at, text.find('\n', at) + 1 - at);
  };
  for (const std::string damaged : {"tracks.csv", "protrusions.csv", "msd.csv", "summary.json", "run.json"})
    for (const std::string how : {"gone", "rubbish", "cut"}) {
      fs::remove_all(folder / "e-study");
      fs::copy(folder / "whole", folder / "e-study", fs::copy_options::recursive);
      const std::string text = file(path(name) + "/" + damaged);
      how == "gone" ? static_cast<void>(fs::remove(folder / path(name) / damaged))
                    : write(path(name) + "/" + damaged, how == "cut" ? text.substr(0, text.size() / 2) : "rubbish\n");
      const bool made_again = damaged.ends_with(".json");
      const Ended collected = run("study collect e-study");
      EXPECT_EQ(collected.code, 5) << damaged << how;
      EXPECT_TRUE(contains(collected.err, "damaged     ")) << collected.err;
      EXPECT_TRUE(contains(collected.err, damaged)) << collected.err;
      const auto status = run("study status e-study");
      EXPECT_TRUE(contains(status.out, " 1 damaged") && contains(status.out, damaged)) << status.out;
      EXPECT_TRUE(contains(collected.err, made_again ? "`study run` makes it again" : "remove runs/" + name))
          << collected.err;
      EXPECT_EQ(rows_but(file("e-study/results.csv")), rows_but(table)) << damaged << how;
      const Ended again = run("study run e.toml --jobs 1");
      EXPECT_EQ(again.code, made_again ? 0 : 5) << damaged << how << again.out << again.err;
      if (!made_again) fs::remove_all(folder / path(name));
      EXPECT_EQ(run("study run e.toml --jobs 1").code, 0) << damaged << how;
      EXPECT_EQ(file("e-study/results.csv"), table) << damaged << how;
      EXPECT_EQ(trajectory(path(name)), trajectory("whole/runs/" + name));
    }
}

TEST_F(OtherVersion, ASummaryThatWasEditedIsNotBelieved) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  change(path(names().front()) + "/summary.json", "\"n_unadhered\": 0", "\"n_unadhered\": 7");
  const Ended collected = run("study collect e-study");
  EXPECT_EQ(collected.code, 5) << collected.out;
  EXPECT_TRUE(contains(collected.err, "summary.json: has been cut or changed since the run ended")) << collected.err;
}

TEST_F(OtherVersion, ATableThatWasEditedToTheSameLengthIsNotBelieved) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  const std::string tracks = path(names().front()) + "/tracks.csv";
  std::string text = file(tracks);
  char& digit = text.at(text.find_last_of("0123456789"));
  digit = digit == '1' ? '2' : '1';
  std::ofstream(folder / tracks, std::ios::binary) << text;
  const Ended collected = run("study collect e-study");
  EXPECT_EQ(collected.code, 5) << collected.out;
  EXPECT_TRUE(contains(collected.err, "tracks.csv: has been cut or changed since the run ended")) << collected.err;
}

TEST_F(OtherVersion, ASmallerStudyHasASmallerTable) {
  ASSERT_EQ(run("study run e.toml --jobs 2").code, 0);
  write_study(1);
  const Ended smaller = run("study run e.toml --jobs 2");
  EXPECT_EQ(smaller.code, 0) << smaller.err;
  EXPECT_EQ(std::ranges::count(file("e-study/results.csv"), '\n'), 3);
}

} // namespace
} // namespace matrigrate
