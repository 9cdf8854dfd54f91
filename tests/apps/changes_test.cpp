#include "program.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <string>

namespace matrigrate {
namespace {

using nlohmann::json;

/// A small run with two changes of parameters, and the same without them.
class Changes : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    const std::string cell =
        "[ecm]\nradius = \"40 um\"\n[protrusion]\ninitiation_rate = \"0.001 1/s\"\n[output]\n"
        "track_interval = \"4 s\"\ncheckpoint_interval = \"7 s\"\nkept_checkpoint_interval = \"12 s\"\n"
        "field_interval = \"9 s\"\n[run]\nduration = \"32 s\"\n";
    write("s.toml", cell);
    write("c.toml", cell
                        + "[[changes]]\nat = \"20 s\"\nfibres.arrangement = \"isotropic\"\n[[changes]]\nat = \"10 s\"\n"
                          "actomyosin.force = \"2 nN\"\necm.viscosity = \"3000 Pa s\"\n");
  }
  json record(const std::string& of) const { return json::parse(text_of(folder / of / "run.json")); }
  void expect_same_tables(const std::string& a, const std::string& b) const {
    EXPECT_EQ(record(a).at("trajectory_hash"), record(b).at("trajectory_hash"));
    for (const char* file : {"tracks.csv", "health.csv", "protrusions.csv", "summary.json"})
      EXPECT_EQ(text_of(folder / a / file), text_of(folder / b / file)) << file;
  }
};

TEST_F(Changes, AreTheSameAsBranchesAndForAnyThreads) {
  ASSERT_EQ(run("run c.toml -o whole --quiet").code, 0);
  ASSERT_EQ(run("run c.toml -o threads --threads 2 --quiet").code, 0);
  expect_same_tables("threads", "whole");
  ASSERT_EQ(run("run s.toml -o plain --quiet").code, 0);
  EXPECT_NE(record("plain").at("trajectory_hash"), record("whole").at("trajectory_hash"));
  ASSERT_EQ(
      run("resume plain --at '10 s' --set 'actomyosin.force=2 nN' --set 'ecm.viscosity=3000 Pa s' -o one --quiet").code,
      0);
  ASSERT_EQ(run("resume one --at '20 s' --set fibres.arrangement=isotropic -o two --quiet").code, 0);
  expect_same_tables("two", "whole");
  ASSERT_EQ(run("run whole/scenario.resolved.toml -o again --quiet").code, 0);
  expect_same_tables("again", "whole");
  EXPECT_EQ(record("again").at("configuration_hash"), record("whole").at("configuration_hash"));
  EXPECT_EQ(record("whole").at("changes").at(0), json({{"at_s", 10.0}, {"what", "actomyosin.force 0.6 -> 2 nN"}}));
  EXPECT_TRUE(contains(text_of(folder / "whole/report.html"), "at 20 s: fibres.arrangement"));
}

TEST_F(Changes, AreMadeAfterAKillBeforeAtAndAfterThem) {
  ASSERT_EQ(run("run c.toml -o whole --quiet").code, 0);
  for (const char* seen : {"t_00012s.h5", "t_00024s.h5"}) {
    const std::string here = std::string("killed-") + seen;
    stopped(fmt::format("run c.toml -o {} --quiet", here), here + "/checkpoints/" + seen, "kill -s KILL $p");
    ASSERT_EQ(run("run c.toml --quiet -o " + here).code, 0);
    expect_same_tables(here, "whole");
  }
  // A stop exactly at a change.
  ASSERT_EQ(run("run c.toml -o there --set 'output.kept_checkpoint_interval=10 s' --quiet").code, 0);
  const auto checkpoint = folder / "there/checkpoints/t_00010s.h5";
  std::filesystem::copy_file(checkpoint, folder / "there/checkpoint.h5",
                             std::filesystem::copy_options::overwrite_existing);
  json interrupted = record("there");
  interrupted["status"] = "interrupted";
  write("there/run.json", interrupted.dump());
  ASSERT_EQ(run("resume there --quiet").code, 0);
  expect_same_tables("there", "whole");
}

TEST_F(Changes, AreInForceWhereABranchBegins) {
  ASSERT_EQ(run("run c.toml -o whole --quiet").code, 0);
  const Ended ended = run("resume whole --at '16 s' --set 'cell.dashpot=0.003 N s/m' -o branch --quiet");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string scenario = text_of(folder / "branch/scenario.resolved.toml");
  EXPECT_TRUE(contains(scenario, "force = \"2 nN\"")) << "what holds at 16 s";
  EXPECT_TRUE(contains(scenario, "at = \"20 s\"")) << "what is to come";
  EXPECT_FALSE(contains(scenario, "at = \"10 s\"")) << "what is past";
  const Ended warned =
      run("resume whole --at '16 s' --set fibres.arrangement=uniaxial --set 'fibres.stiffness=1 Pa' -o w");
  ASSERT_EQ(warned.code, 0) << warned.err;
  EXPECT_TRUE(contains(warned.err, "fibres.arrangement = \"uniaxial\" holds until 20 s")) << warned.err;
  ASSERT_EQ(run("resume whole --at '16 s' --set changes=[] -o none --quiet").code, 0);
  EXPECT_FALSE(contains(text_of(folder / "none/scenario.resolved.toml"), "[[changes]]"));
  const Ended second = run("resume branch --at '8 s' --set 'cell.dashpot=0.003 N s/m' -o second");
  EXPECT_EQ(second.code, 3);
  EXPECT_TRUE(contains(second.err, "it is a branch, whose past up to 16 s had other parameters")) << second.err;
  EXPECT_FALSE(exists("second"));
}

TEST_F(Changes, AreNamedByCheckAndExplain) {
  for (const char* verb : {"check c.toml", "explain c.toml"}) {
    const Ended ended = run(verb);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(contains(ended.out, "at 10 s: actomyosin.force 0.6 -> 2 nN\n")) << ended.out;
  }
  EXPECT_EQ(json::parse(run("explain c.toml --json").out).at("changes").size(), 3U);
}

TEST_F(Changes, ThatCannotBeWriteNothing) {
  write("bad.toml",
        "[run]\nduration = \"60 s\"\n[[changes]]\nat = \"60 s\"\ncell.dashpot = 0.003\n[[changes]]\nat = \"8 s\"\n"
        "ecm.radius = \"50 um\"\n[[changes]]\nat = \"12 s\"\necm.youngs_modulus = \"1e6 Pa\"\n");
  const Ended ended = run("run bad.toml -o bad");
  EXPECT_EQ(ended.code, 3);
  EXPECT_FALSE(exists("bad"));
  for (const char* said :
       {"bad.toml:4:6: changes[1].at: 1 min is not before", "bad.toml:8:14: changes[2].ecm.radius: cannot",
        "bad.toml:11:22: changes[3].ecm.youngs_modulus: from 12 s on: "})
    EXPECT_TRUE(contains(ended.err, said)) << ended.err;
  write("study.toml", "scenario = \"c.toml\"\nreplicates = 1\n[sweep]\nactomyosin.force = [\"0.4 nN\", \"0.6 nN\"]\n");
  EXPECT_EQ(run("study plan study.toml").code, 0);
  write("short.toml", "scenario = \"c.toml\"\nreplicates = 1\n[sweep]\nrun.duration = [\"16 s\", \"32 s\"]\n");
  const Ended shorter = run("study plan short.toml");
  EXPECT_EQ(shorter.code, 3);
  EXPECT_TRUE(contains(shorter.err, "short.toml:4:17: run.duration: changes: 20 s is not before the end"))
      << shorter.err;
}

} // namespace
} // namespace matrigrate
