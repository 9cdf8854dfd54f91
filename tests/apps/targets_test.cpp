#include "program.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Studies with targets, of a cell in a small disc that is followed for a few steps.
class TargetStudy : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"8 s\"\n[protrusion]\ninitiation_rate = \"0.01 "
                    "1/s\"\n[output]\ntrack_interval = \"2 s\"\n");
  }

  void write_study(const std::string& more) const {
    write("e.toml",
          "scenario = \"s.toml\"\nreplicates = 2\nreadouts = [\"v_migr_abs_um_per_h\", \"n_protrusions\"]\n" + more);
  }

  std::string file(const std::string& name) const { return text_of(folder / name); }
};

const std::string sweep = "[sweep]\nprotrusion.initiation_rate = [\"0.01 1/s\", \"0.05 1/s\", \"0.1 1/s\"]\n";
const std::string conditions = "[[conditions]]\nlabel = \"soft\"\necm.youngs_modulus = \"50 Pa\"\n[[conditions]]\n"
                               "label = \"stiff\"\necm.youngs_modulus = \"400 Pa\"\n";
const std::string target = "[[targets]]\nreadout = \"n_protrusions\"\nvalue = 2\nerror = 0.5\n";

TEST_F(TargetStudy, KeepsTargetsForThePageAndForFits) {
  write_study(sweep + conditions + target + "at = \"soft\"\n");
  EXPECT_TRUE(
      contains(run("study plan e.toml").out, "6 points (3 factor sets x 2 conditions) x 2 replicates = 12 runs"));
  const Ended ended = run("study run e.toml --jobs 2");
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const json page = json::parse(page_data("e-study/report.html"));
  EXPECT_EQ(page.at("targets").at(0).at("at"), "soft");
  EXPECT_TRUE(contains(file("e-study/study.resolved.toml"), "[[targets]]\nreadout = \"n_protrusions\"\nvalue = 2"));
  EXPECT_TRUE(contains(run("study run e-study/study.resolved.toml").out, "0 of them now"));
  EXPECT_FALSE(exists("e-study/discrepancy.csv"));
  std::filesystem::remove_all(folder / "e-study/runs");
  EXPECT_NE(run("study collect e-study").code, 0) << "the table of the runs that are gone stays";
}

TEST_F(TargetStudy, WritesNothingOnAFault) {
  write_study("[morris]\ntrajectories = 3\n[latin_hypercube]\nprotrusion.force = [\"0.6 nN\", \"0.2 nN\"]\n"
              "ecm.youngs_modulus = [50, 60]\n"
              + conditions + "[[targets]]\nreadout = \"n_protrusion\"\nvalue = 2\nerror = 0\nat = \"sofd\"\n");
  const Ended ended = run("study run e.toml");
  EXPECT_EQ(ended.code, 3);
  for (const char* part :
       {"e.toml:4:2: morris: is no design any more; draw the ranges by [latin_hypercube]",
        "e.toml:6:1: latin_hypercube.samples: is missing", "protrusion.force: \"0.6 nN\" is not below \"0.2 nN\"",
        "e.toml:8:22: ecm.youngs_modulus: is also set by the condition \"soft\"", "did you mean n_protrusions?",
        "e.toml:18:9: targets.error: 0 is out of range; allowed are 1e-30", "did you mean soft?"})
    EXPECT_TRUE(contains(ended.err, part)) << part << '\n' << ended.err;
  EXPECT_EQ(entries(), 2U);
  write("alone.toml", "[morris]\ntrajectories = 1\n");
  EXPECT_TRUE(contains(run("check alone.toml").err, "morris: is no design any more")) << "is a study";
}

} // namespace
} // namespace matrigrate
