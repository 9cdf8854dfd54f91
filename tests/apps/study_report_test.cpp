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
  json data(const std::string& file) const { return json::parse(page_data(file)); }
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
    EXPECT_TRUE(contains(player.at("label"), "the middle one by v_migr_abs_um_per_h"));
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
  EXPECT_TRUE(summary.starts_with("v_migr_abs is lowest, ")) << summary;
  EXPECT_TRUE(summary.ends_with("; no comparison has 3 runs at both points.")) << summary;
}

TEST_F(StudyReport, IsMadeAnew) {
  ASSERT_EQ(run("study run e.toml").code, 0);
  const json before = data("e-study/report.html");
  std::filesystem::remove(folder / "e-study/report.html");
  const Ended picture = run("export e-study --svg"); // of one run at a time
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
  const json before = page.at("claims");
  ASSERT_EQ(run("report reproduce/contraction").code, 0);
  EXPECT_EQ(data("reproduce/contraction/report.html").at("claims"), before) << "from the folder alone";
}

} // namespace
} // namespace matrigrate
