#include "program.hpp"

#include <nlohmann/json.hpp>

#include <set>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Pages of studies of a cell in a small disc, followed for a few steps.
class StudyReport : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"8 s\"\n[protrusion]\ninitiation_rate = \"0.01 "
                    "1/s\"\n[output]\ntrack_interval = \"2 s\"\nfield_interval = \"4 s\"\n");
    write("e.toml", "title = \"Stiffness\"\nscenario = \"s.toml\"\nreplicates = 2\n"
                    "readouts = [\"v_migr_abs_um_per_h\"]\n[sweep]\necm.youngs_modulus = [\"50 Pa\", \"100 Pa\"]\n");
  }
  json data(const std::string& name) const { return json::parse(page_data(name)); }
  std::string file(const std::string& name) const { return text_of(folder / name); }
};

TEST_F(StudyReport, ShowsShapesAndPlaysTypicalRuns) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const json page = data("e-study/report.html");
  std::set<std::string> ids;
  for (const json& shown : page.at("runs")) {
    EXPECT_EQ(shown.at("outline").at("x_um").size(), 235U) << "the particles of the cortex";
    EXPECT_TRUE(exists("e-study/" + shown.at("report").get<std::string>()));
    ids.insert(shown.at("id"));
  }
  ASSERT_EQ(page.at("players").size(), 2U) << "one a point";
  for (const json& player : page.at("players")) {
    EXPECT_TRUE(ids.contains(player.at("id")));
    EXPECT_TRUE(contains(player.at("label"), "the middle one by speed, start to end"));
    EXPECT_EQ(player.at("run").at("frames").at("times_s"), json::parse("[0.0, 4.0, 8.0]"));
  }
  EXPECT_TRUE(page.at("claims").empty()) << "no study of the paper";
}

TEST_F(StudyReport, BeginsWithWhatWasComputedAndWhatCameOut) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const json page = data("e-study/report.html");
  EXPECT_EQ(page.at("title"), "Stiffness: 2 points x 2 replicates");
  EXPECT_EQ(page.at("facts").at(0).at("value"), "matrigrate study run e-study/study.resolved.toml");
  EXPECT_TRUE(page.at("facts").at(1).at("value").get<std::string>().ends_with(" UTC"));
  EXPECT_TRUE(page.at("facts").at(2).at("value").get<std::string>().starts_with("matrigrate 0."));
  EXPECT_EQ(page.at("facts").at(3).at("value"), "4 of 4");
  const std::string summary = page.at("summary");
  EXPECT_TRUE(summary.starts_with("Speed, start to end (v_migr_abs) goes from ")) << summary;
  EXPECT_TRUE(summary.ends_with("; of fewer than 3 runs none is called the lowest or the highest.")) << summary;
}

TEST_F(StudyReport, IsMadeAnew) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const json before = data("e-study/report.html");
  std::filesystem::remove(folder / "e-study/report.html");
  const Ended picture = run("export e-study --fields"); // of one run at a time
  EXPECT_EQ(picture.code, 5);
  EXPECT_TRUE(contains(picture.err, "e-study: is the folder of a study; name one of its runs, e-study/runs/NAME"))
      << picture.err;
  const Ended ended = run("report e-study");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "open e-study/report.html\n");
  EXPECT_EQ(data("e-study/report.html"), before);
  const std::string first = before.at("runs").at(0).at("id");
  const std::string second = before.at("runs").at(1).at("id");
  ASSERT_EQ(run("report e-study --play " + second + " --play " + first).code, 0);
  const json chosen = data("e-study/report.html").at("players");
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen.at(0).at("id"), second);
  EXPECT_EQ(chosen.at(1).at("id"), first);
  EXPECT_EQ(run("report e-study --play nonsense").code, 2);
  EXPECT_EQ(run("report e-study/runs/" + first + " --play " + first).code, 2);
}

TEST_F(StudyReport, NamesWhatAReadOnlyFileSystemRefuses) {
  if (std::system("unshare -m true 2>/dev/null") != 0) GTEST_SKIP() << "there are no mounts of one's own here";
  ASSERT_EQ(run("study run e.toml").code, 0);
  const std::string mounted = "mount --bind . . && mount -o remount,ro,bind . . && cd \"$PWD\" && exec ";
  const Ended ended = run("-m sh -c '" + mounted + MATRIGRATE_PROGRAM " report e-study'", "unshare");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "report.html")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "Read-only file system")) << ended.err;
  EXPECT_FALSE(contains(ended.err, "claims.csv")) << "which is not there: " << ended.err;
}

TEST_F(StudyReport, DoesWithoutCheckpoints) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const std::string id = data("e-study/report.html").at("players").at(0).at("id");
  for (const char* name : {"checkpoint.h5", "checkpoint_prev.h5"})
    std::filesystem::remove(folder / "e-study/runs" / id / name);
  ASSERT_EQ(run("report e-study").code, 0);
  const json page = data("e-study/report.html");
  EXPECT_EQ(page.at("players").size(), 1U);
  for (const json& shown : page.at("runs")) EXPECT_EQ(shown.at("outline").is_null(), shown.at("id") == id);
  EXPECT_EQ(run("report e-study --play " + id).code, 5);
}

/// Two tracks of different lengths, one with a gap: good enough to be drawn.
const std::string measured = "track,t_s,x_um,y_um\na,0,5,5\na,2,6,5\na,6,8,5\nb,10,0,0\nb,12,0,3\n";

TEST_F(StudyReport, DrawsMeasuredTracksOverARun) {
  write("cells.csv", measured);
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  EXPECT_TRUE(!data("r/report.html").contains("measured"));
  const Ended ended = run("report r --tracks cells.csv");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(data("r/report.html").at("measured"),
            json::parse(R"({"total":2,"t_s":[0,2,6,null,0,2],"x_um":[0,1,3,null,0,0],"y_um":[0,0,0,null,0,3]})"));
  ASSERT_EQ(run("report r").code, 0);
  EXPECT_TRUE(data("r/report.html").at("measured").is_null()) << "the option is not kept";
  write("frames.csv", "particle,frame,x,y\n0,0,2,2\n0,1,4,2\n1,0,0,0\n");
  const Ended frames = run("report r --tracks frames.csv --pixel 0.5 --interval 2");
  ASSERT_EQ(frames.code, 0) << frames.err;
  EXPECT_EQ(data("r/report.html").at("measured"), json::parse(R"({"total":1,"t_s":[0,2],"x_um":[0,1],"y_um":[0,0]})"));
  EXPECT_TRUE(contains(frames.out, "frames.csv: 1 track of fewer than 2 positions is left out")) << frames.out;
}

TEST_F(StudyReport, FaultsOfMeasuredTracksLeaveThePageAsItIs) {
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  const std::string before = file("r/report.html");
  write("bad.csv", "track,t_s,x_um,y_um\na,0,5,5\na,0,6,five\nb,1,1,1\n");
  const Ended bad = run("report r --tracks bad.csv");
  EXPECT_EQ(bad.code, 3);
  EXPECT_TRUE(contains(bad.err, "bad.csv:3:1: y_um: \"five\" is no finite number")) << bad.err;
  write("bad.csv", "track,t_s,x_um,y_um\na,0,5,5\na,0,6,5\nb,1,1,1\n");
  const Ended falling = run("report r --tracks bad.csv");
  EXPECT_EQ(falling.code, 3);
  EXPECT_TRUE(contains(falling.err, "bad.csv:3:1: track a has two positions at 0 s")) << falling.err;
  EXPECT_EQ(run("report r --tracks nowhere.csv").code, 5);
  EXPECT_EQ(file("r/report.html"), before);
}

TEST_F(StudyReport, DrawsTheMeasuredTracksOfItsTargets) {
  write("cells.csv", "track,t_s,x_um,y_um\n1,0,0,0\n1,2,1,0\n1,4,2,0.125\n2,7,3,3\n2,9,3,4.1\n2,11,3,5\n");
  write("t.toml", file("e.toml") + "[[targets]]\nreadout = \"v_migr_abs_um_per_h\"\ntracks = \"cells.csv\"\n");
  ASSERT_EQ(run("study run t.toml").code, 0);
  std::filesystem::remove(folder / "cells.csv"); // the folder of the study has its own
  const json page = data("t-study/report.html");
  ASSERT_EQ(page.at("measured").size(), 1U);
  EXPECT_EQ(page.at("measured").at(0).at("total"), 2);
  EXPECT_EQ(page.at("measured").at(0).at("points").size(), 2U);
  for (const json& player : page.at("players")) EXPECT_EQ(player.at("run").at("measured").at("total"), 2);
  ASSERT_EQ(run("report t-study").code, 0);
  EXPECT_EQ(data("t-study/report.html"), page) << "from the folder alone";
  const std::string resolved = file("t-study/study.resolved.toml");
  EXPECT_TRUE(contains(resolved, "tracks = \"measured-1.csv\"")) << resolved;
  ASSERT_EQ(run("study run t-study/study.resolved.toml -o again").code, 0);
  EXPECT_EQ(file("again/measured-1.csv"), file("t-study/measured-1.csv"));
  write("more.csv", measured);
  ASSERT_EQ(run("report t-study --tracks more.csv").code, 0);
  EXPECT_EQ(data("t-study/report.html").at("measured").size(), 2U);
}

TEST_F(StudyReport, NeedsARunOrAStudy) {
  std::filesystem::create_directory(folder / "empty");
  for (const char* name : {"empty", "nowhere"}) {
    const Ended ended = run(std::string("report ") + name);
    EXPECT_EQ(ended.code, 5);
    EXPECT_TRUE(contains(ended.err, "neither a run (no run.json) nor a study (no study.resolved.toml)")) << ended.err;
  }
}

TEST_F(StudyReport, JudgesTheClaimsOfThePaper) {
  ASSERT_EQ(run("reproduce A8 --set 'ecm.radius=40 um' --set 'run.duration=8 s' --replicates 2").code, 4);
  const json page = data("reproduce/contraction/report.html");
  ASSERT_FALSE(page.at("claims").empty());
  std::set<std::string> ids;
  for (const json& claim : page.at("claims")) {
    ids.insert(claim.at("id"));
    EXPECT_FALSE(claim.at("sentence").get<std::string>().empty());
    EXPECT_FALSE(claim.at("statistic").empty());
    EXPECT_EQ(claim.at("caveat"), "not the paper's runs");
    for (const char* key : {"published", "verdict", "ours"}) EXPECT_TRUE(claim.contains(key)) << key;
  }
  EXPECT_TRUE(ids.contains("A8"));
  const std::string note = page.at("claims_note");
  for (const char* part : {"replicates 2 (published: 12)", "run.integrator", "no verdicts on the paper"})
    EXPECT_TRUE(contains(note, part)) << note;
  const json& before = page.at("claims");
  ASSERT_EQ(run("report reproduce/contraction").code, 0);
  EXPECT_EQ(data("reproduce/contraction/report.html").at("claims"), before) << "from the folder alone";
}

} // namespace
} // namespace matrigrate
