#include "program.hpp"

#include <nlohmann/json.hpp>

namespace matrigrate {
namespace {

using nlohmann::json;

TEST_F(Program, HelpOfEveryVerb) {
  EXPECT_EQ(run("-h").code, 0);
  for (const std::string verb : {"new", "list", "check", "explain", "run", "validate", "study", "reproduce", "info"}) {
    const Ended ended = run(verb + " -h");
    EXPECT_EQ(ended.code, 0) << verb;
    EXPECT_TRUE(contains(ended.out, "Usage: matrigrate " + verb)) << ended.out;
    EXPECT_TRUE(contains(run("-h").out, "\n  " + verb + " "));
  }
  EXPECT_TRUE(contains(run("--version").out, "matrigrate 0."));
}

TEST_F(Program, UsageErrors) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("check").code, 2);
  EXPECT_EQ(run("info --nonsense").code, 2);
  EXPECT_EQ(run("list --parameters --schema-json").code, 2);
  const Ended verb = run("exlpain f.toml");
  EXPECT_EQ(verb.code, 2);
  EXPECT_TRUE(contains(verb.err, "there is no verb \"exlpain\"; did you mean explain?")) << verb.err;
  const Ended preset = run("new f.toml --preset sotf");
  EXPECT_EQ(preset.code, 2);
  EXPECT_TRUE(contains(preset.err, "did you mean soft?")) << preset.err;
  const Ended which = run("validate pach");
  EXPECT_EQ(which.code, 2);
  EXPECT_TRUE(contains(which.err, "did you mean patch?")) << which.err;
  EXPECT_EQ(entries(), 0u) << "nothing is written on an error";
}

TEST_F(Program, NewWritesAScenarioOnce) {
  EXPECT_EQ(run("new a.toml").code, 0);
  EXPECT_EQ(run("check a.toml").out, "a.toml: good\n");
  EXPECT_TRUE(contains(text_of(folder / "a.toml"), "\nyoungs_modulus = \"200 Pa\"\n"));
  EXPECT_EQ(run("new soft.toml --preset soft").code, 0);
  EXPECT_TRUE(contains(text_of(folder / "soft.toml"), "\nyoungs_modulus = \"50 Pa\"\n"));
  write("mine.toml", "mine");
  const Ended again = run("new mine.toml");
  EXPECT_EQ(again.code, 5);
  EXPECT_TRUE(contains(again.err, "mine.toml: exists, and is not overwritten")) << again.err;
  EXPECT_EQ(text_of(folder / "mine.toml"), "mine");
  EXPECT_EQ(run("new nowhere/a.toml").code, 5);
}

TEST_F(Program, AFileSizeLimitIsAnErrorOfOutput) {
  const std::string shell =
      "bash -c 'ulimit -f 0; exec \"" MATRIGRATE_PROGRAM "\" new \"" + folder.string() + "/a.toml\" 2>/dev/null'";
  const int status = std::system(shell.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 5);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(Program, SelftestHoldsHere) {
  const Ended ended = run("selftest --json");
  ASSERT_EQ(ended.code, 0) << ended.out;
  const json found = json::parse(ended.out);
  EXPECT_TRUE(found.at("holds"));
  EXPECT_EQ(found.at("checks").size(), 6u);
  const Ended with = run("selftest --with '" MATRIGRATE_PROGRAM "'");
  EXPECT_EQ(with.code, 0);
  EXPECT_TRUE(contains(with.out, std::string(MATRIGRATE_PROGRAM) + ": the same bits")) << with.out;
  const Ended none = run("selftest --with /nowhere/matrigrate");
  EXPECT_EQ(none.code, 5);
  EXPECT_TRUE(contains(none.err, "/nowhere/matrigrate: there is no such program")) << none.err;
}

TEST_F(Program, CheckTellsEveryFaultOfEveryFile) {
  write("good.toml", "[ecm]\nyoungs_modulus = \"50 Pa\"\n");
  write("bad.toml", "[ecm]\nyoungs_modulu = 1\nradius = \"150 Pa\"\nviscosity = 1000 Pa s\n");
  const Ended ended = run("check bad.toml good.toml none.toml");
  EXPECT_EQ(ended.code, 5) << "none.toml";
  EXPECT_EQ(ended.out, "good.toml: good\n");
  EXPECT_TRUE(ended.err.starts_with(
      "bad.toml:2:1: ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?\nbad.toml:3:10: "
      "ecm.radius: \"150 Pa\" is a stress, but a length is expected; write it like \"150 um\"\nbad.toml:4:18: "
      "ecm.viscosity: "))
      << ended.err;
  EXPECT_TRUE(ended.err.ends_with("none.toml: cannot be read: No such file or directory\n")) << ended.err;
  EXPECT_EQ(run("check bad.toml good.toml").code, 3);
  EXPECT_EQ(run("check good.toml").code, 0);
  EXPECT_EQ(run("check .").code, 5);
}

TEST_F(Program, CheckSpeaksJson) {
  write("bad.toml", "[ecm]\nradius = \"150 Pa\"\n");
  const Ended ended = run("check --json bad.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.err, "");
  const json found = json::parse(ended.out);
  EXPECT_FALSE(found.at("good").get<bool>());
  const json& fault = found.at("files").at(0).at("faults").at(0);
  EXPECT_EQ(fault.at("line"), 2);
  EXPECT_EQ(fault.at("column"), 10);
  EXPECT_EQ(fault.at("key"), "ecm.radius");
}

TEST_F(Program, ListShowsWhatShips) {
  const Ended ended = run("list");
  EXPECT_EQ(ended.code, 0);
  for (const char* name : {"\n  baseline ", "\n  soft ", "\n  stiff ", "\n  patch ", "\n  creep ", "\n  stiffness "})
    EXPECT_TRUE(contains(ended.out, name)) << name;
  EXPECT_TRUE(contains(run("list --parameters").out, "| `youngs_modulus` | `\"200 Pa\"` |"));
  EXPECT_TRUE(json::parse(run("list --schema-json").out).contains("properties"));
}

TEST_F(Program, InfoTellsWhatItIs) {
  const json info = json::parse(run("info --json").out);
  for (const char* key : {"version", "git_hash", "git_dirty", "compiler", "flags", "libraries", "cpu"})
    EXPECT_TRUE(info.contains(key)) << key;
  EXPECT_TRUE(contains(run("info").out, info.at("compiler").get<std::string>()));
}

TEST_F(Program, ExplainTellsDerivedQuantities) {
  ASSERT_EQ(run("new a.toml").code, 0);
  const Ended plain = run("explain a.toml");
  EXPECT_EQ(plain.code, 0);
  EXPECT_TRUE(contains(plain.out, "666.7 Pa")) << plain.out;
  const json derived = json::parse(run("explain a.toml --json").out);
  EXPECT_NEAR(derived.at("bulk_modulus_Pa").get<double>(), 200.0 / 0.3, 1e-9);
  EXPECT_NEAR(derived.at("shear_modulus_Pa").get<double>(), 200.0 / 2.9, 1e-9);
  EXPECT_NEAR(derived.at("shear_relaxation_s").get<double>(), 14.5, 1e-9);
  EXPECT_EQ(derived.at("steps"), 54000.0);
  EXPECT_NEAR(derived.at("particles").get<double>(), 3.14159265 * 75 * 75, 100.0);
  EXPECT_EQ(derived.at("neighbours"), 20.0);
  EXPECT_NEAR(derived.at("cortex_segment_um").get<double>(), 0.401, 1e-3);
  EXPECT_NEAR(derived.at("mean_wait_protrusion_s").get<double>(), 1.0 / (117 * 6e-5), 1e-6);
  EXPECT_TRUE(contains(run("explain a.toml --set 'protrusion.initiation_rate=0 1/s'").out, "never"));
  EXPECT_GT(derived.at("step_limit_elastic_s").get<double>(), 0.4);
  EXPECT_TRUE(derived.at("warnings").empty());
}

TEST_F(Program, ExplainWarnsOfAStepBeyondTheLimit) {
  ASSERT_EQ(run("new a.toml").code, 0);
  const Ended ended = run("explain a.toml --set 'run.time_step=40 s'");
  EXPECT_EQ(ended.code, 0);
  EXPECT_TRUE(contains(ended.out, "WARNING: the time step of 40 s is beyond the largest stable one")) << ended.out;
  EXPECT_FALSE(contains(run("explain a.toml").out, "WARNING"));
  const Ended bad = run("explain a.toml --set run.time_stp=1 --set ecm.radius=3");
  EXPECT_EQ(bad.code, 3);
  EXPECT_EQ(bad.err, "--set: run.time_stp: there is no such parameter; did you mean run.time_step?\n"
                     "--set: ecm.radius: 3 um is out of range; allowed is >= 10 and <= 2000 um\n");
  EXPECT_EQ(run("explain none.toml").code, 5);
}

TEST_F(Program, ColourOnlyOnATerminal) { EXPECT_FALSE(contains(run("list").out, "\x1b")); }

TEST_F(Program, WhatCannotBePrintedIsAnError) {
  for (const char* arguments : {"list", "--help", "run --help", "--version"})
    for (const char* output : {">/dev/full", ">&-"}) {
      const std::string command = std::string("'" MATRIGRATE_PROGRAM "' ") + arguments + " " + output + " 2>/dev/null";
      EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 5) << command;
    }
}

TEST_F(Program, AFileThatIsNotThereIsAnErrorOfInput) {
  write("study.toml", "scenario = \"none.toml\"\nreplicates = 2\n[sweep]\necm.youngs_modulus = [\"50 Pa\"]\n");
  for (const char* arguments :
       {"check none.toml", "explain none.toml", "run none.toml", "validate patch --scenario none.toml", "resume none",
        "report none", "export none --svg", "study plan none.toml", "study run none.toml", "study submit none.toml",
        "study status none", "study collect none", "study plan study.toml"}) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 5) << arguments << '\n' << ended.err;
    EXPECT_TRUE(contains(ended.err, "none")) << ended.err;
  }
  EXPECT_EQ(entries(), 1U);
}

} // namespace
} // namespace matrigrate
