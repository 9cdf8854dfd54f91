#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <set>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Screening studies of a cell in a small disc, followed for a few steps.
class ScreeningStudy : public Program {
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

const std::string one_at_a_time = "[one_at_a_time]\nprotrusion.force = [\"0.32 nN\", \"0.6 nN\"]\n"
                                  "protrusion.initiation_rate = [\"0.1 1/s\"]\n";
const std::string conditions = "[[conditions]]\nlabel = \"soft\"\necm.youngs_modulus = \"50 Pa\"\n[[conditions]]\n"
                               "label = \"stiff\"\necm.youngs_modulus = \"400 Pa\"\n";
const std::string target = "[[targets]]\nreadout = \"n_protrusions\"\nvalue = 2\nerror = 0.5\n";

TEST_F(ScreeningStudy, RanksFactorsOneAtATimeAtConditions) {
  write_study(one_at_a_time + conditions + target + "at = \"soft\"\n");
  EXPECT_TRUE(
      contains(run("study plan e.toml").out, "6 points (3 factor sets x 2 conditions) x 2 replicates = 12 runs"));
  const Ended ended = run("study run e.toml --jobs 2");
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const json plan = json::parse(run("study plan e.toml --json").out);
  std::set<std::uint64_t> seeds;
  for (const json& planned : plan.at("runs")) seeds.insert(planned.at("seed").get<std::uint64_t>());
  EXPECT_EQ(seeds.size(), 2U) << "common random numbers";

  const std::string effects = file("e-study/effects.csv");
  EXPECT_TRUE(effects.starts_with("design,readout,condition,rank,factor,value,paired,n,effect,")) << effects;
  EXPECT_EQ(std::ranges::count(effects, '\n'), 1 + 2 * (1 + 2 * 2)) << "two factors, a discrepancy, 2 read-outs";
  EXPECT_TRUE(contains(effects, "\none_at_a_time,discrepancy,,1,protrusion.initiation_rate,0.1 1/s,true,1,"))
      << effects;
  const std::string sets = file("e-study/discrepancy.csv");
  EXPECT_EQ(std::ranges::count(sets, '\n'), 4);
  EXPECT_TRUE(contains(sets, "z_n_protrusions_at_soft")) << sets;
  EXPECT_FALSE(contains(sets, "at_stiff")) << sets;

  const std::string text = run("study collect e-study").out;
  EXPECT_TRUE(contains(text, "discrepancy from the targets\n  factors ")) << text;
  EXPECT_TRUE(contains(text, "factors by effect on n_protrusions (value less base, 95 % interval)\n  factor ")) << text;
  EXPECT_FALSE(contains(text, "none is defined yet")) << text;
  const json page = json::parse(page_data("e-study/report.html"));
  EXPECT_EQ(page.at("screening").at("sets").size(), 3U);
  EXPECT_EQ(page.at("screening").at("effects").size(), 10U);

  EXPECT_TRUE(contains(run("study run e-study/study.resolved.toml").out, "0 of them now"));
  EXPECT_EQ(file("e-study/effects.csv"), effects) << "the resolved study ranks as the first";
  EXPECT_EQ(file("e-study/discrepancy.csv"), sets);
  const json collected = json::parse(run("study collect e-study --json").out);
  EXPECT_TRUE(contains(collected.at("files").dump(), "effects.csv"));
}

TEST_F(ScreeningStudy, MoreTrajectoriesOfMorrisAddRuns) {
  const std::string ranges =
      "protrusion.force = [\"0.2 nN\", \"0.6 nN\"]\nprotrusion.initiation_rate = [\"0.003 1/s\", "
      "\"0.1 1/s\", \"log\"]\nadhesion.rupture = [false, true]\n";
  write_study("[morris]\ntrajectories = 2\n" + ranges);
  const json first = json::parse(run("study run e.toml --json").out);
  EXPECT_EQ(first.at("done"), first.at("runs"));
  EXPECT_FALSE(exists("e-study/discrepancy.csv")) << "there is no target";
  EXPECT_TRUE(contains(file("e-study/effects.csv"), "\nmorris,n_protrusions,,1,protrusion.initiation_rate,,true,2,"))
      << file("e-study/effects.csv");
  write_study("[morris]\ntrajectories = 3\n" + ranges + target);
  const json more = json::parse(run("study run e.toml --json").out);
  EXPECT_GT(more.at("done_now"), 0);
  EXPECT_EQ(more.at("done_now").get<int>(), more.at("runs").get<int>() - first.at("runs").get<int>());
  EXPECT_TRUE(exists("e-study/discrepancy.csv"));
  EXPECT_TRUE(contains(run("study collect e-study").out, "(mu* of Morris, 95 % interval)\n  factor "));
  std::filesystem::remove_all(folder / "e-study/runs");
  EXPECT_NE(run("study collect e-study").code, 0) << "the table of the runs that are gone stays";
  std::filesystem::remove(folder / "e-study/results.csv");
  EXPECT_TRUE(contains(run("study collect e-study").out, "(mu* of Morris, 95 % interval): none is defined yet"));
  write_study("[sweep]\nadhesion.rupture = [false, true]\n");
  ASSERT_EQ(run("study run e.toml --quiet").code, 0);
  EXPECT_FALSE(exists("e-study/effects.csv")) << "of the study as it was";
  EXPECT_FALSE(exists("e-study/discrepancy.csv"));
}

TEST_F(ScreeningStudy, WritesNothingOnAFault) {
  write_study("[morris]\nlevels = 3\nprotrusion.force = [\"0.6 nN\", \"0.2 nN\"]\necm.youngs_modulus = [50, 60]\n"
              + conditions + "[[targets]]\nreadout = \"n_protrusion\"\nvalue = 2\nerror = 0\nat = \"sofd\"\n");
  const Ended ended = run("study run e.toml");
  EXPECT_EQ(ended.code, 3);
  for (const char* part :
       {"e.toml:5:10: morris.levels: 3 is odd", "e.toml:6:20: protrusion.force: \"0.6 nN\" is not below \"0.2 nN\"",
        "e.toml:7:22: ecm.youngs_modulus: is also set by the condition \"soft\"", "did you mean n_protrusions?",
        "e.toml:17:9: targets.error: 0 is out of range; allowed is > 0", "did you mean soft?"})
    EXPECT_TRUE(contains(ended.err, part)) << part << '\n' << ended.err;
  EXPECT_EQ(entries(), 2U);
  write("alone.toml", "[morris]\ntrajectories = 1\n");
  EXPECT_TRUE(contains(run("check alone.toml").err, "morris.trajectories: 1 is out of range")) << "is a study";
}

} // namespace
} // namespace matrigrate
