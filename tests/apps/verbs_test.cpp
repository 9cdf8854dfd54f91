#include "program.hpp"

#include "parameters/presets.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace matrigrate {
namespace {

using nlohmann::json;

TEST_F(Program, CheckNamesMixedClosuresOnce) {
  write("mixed.toml", "[contact]\nfluid_share = 0.15\n");
  const std::string out = run("check mixed.toml").out;
  const auto first = out.find("mixed: of the third set");
  ASSERT_NE(first, std::string::npos) << out;
  EXPECT_EQ(out.find("of the third set", first + 10), std::string::npos) << out;
  EXPECT_FALSE(contains(out, "mixed.toml: closures: ")) << out;
  write("own.toml", "[cell]\nbending_stiffness = \"4e-16 N m\"\n");
  EXPECT_TRUE(contains(run("check own.toml").out, "own.toml: closures: third set, but for cell.bending_stiffness"));
}

/// A step of a small disc is mostly the cell's: 120 of them took 0.09 to 0.1 s of CPU time, and the rest of the run
/// 0.05 s.
TEST_F(Program, ExplainCountsTheStepsOfTheCell) {
  write("small.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"48 s\"\nintegrator = \"reference\"\n");
  const auto estimate = [&](const std::string& more) {
    return json::parse(run("explain small.toml --json" + more).out).at("wall_time_estimate_s").get<double>();
  };
  EXPECT_GT(estimate(""), 0.11);
  EXPECT_LT(estimate(""), 0.18);
  EXPECT_GT(estimate(" --set cell.particles=470"), estimate("") + 0.04);
}

TEST_F(Program, HelpOfEveryVerb) {
  EXPECT_EQ(run("-h").code, 0);
  for (const std::string verb : {"new", "list", "check", "explain", "run", "validate", "study", "reproduce", "info"}) {
    const Ended ended = run(verb + " -h");
    EXPECT_EQ(ended.code, 0) << verb;
    EXPECT_TRUE(contains(ended.out, "Usage: matrigrate " + verb)) << ended.out;
    EXPECT_TRUE(contains(run("-h").out, "\n  " + verb + " "));
  }
  EXPECT_TRUE(contains(run("--version").out, "matrigrate 0."));
  EXPECT_TRUE(contains(run("run -h").out, "fields.h5 and fields.xdmf"));
  EXPECT_TRUE(contains(run("export -h").out, "cells, adhesions and matrix over time"));
}

TEST_F(Program, UsageErrors) {
  EXPECT_EQ(run("check").code, 2);
  EXPECT_EQ(run("info --nonsense").code, 2);
  EXPECT_EQ(run("list --parameters --schema-json").code, 2);
  const Ended verb = run("exlpain f.toml");
  EXPECT_EQ(verb.code, 2);
  EXPECT_TRUE(verb.err.starts_with("matrigrate: there is no verb \"exlpain\"; did you mean explain?\n")) << verb.err;
  const Ended preset = run("new f.toml --preset sotf");
  EXPECT_EQ(preset.code, 2);
  EXPECT_TRUE(contains(preset.err, "there is no preset \"sotf\"; did you mean soft?\nThe presets are: baseline, "))
      << preset.err;
  for (const Template& file : templates()) EXPECT_TRUE(contains(preset.err, std::string(file.name))) << preset.err;
  const Ended law = run("new f.toml --law motor-cluch");
  EXPECT_EQ(law.code, 2);
  EXPECT_TRUE(
      contains(law.err, "there is no law \"motor-cluch\"; did you mean motor-clutch?\nThe laws are: bell-slip-bond, "))
      << law.err;
  EXPECT_EQ(run("new f.toml --law motor-clutch --preset soft").code, 2) << "one of both";
  EXPECT_EQ(run("new f.toml --law ''").code, 2);
  const Ended which = run("validate pach");
  EXPECT_EQ(which.code, 2);
  EXPECT_TRUE(contains(which.err, "did you mean patch?")) << which.err;
  EXPECT_EQ(entries(), 0u) << "nothing is written on an error";
}

TEST_F(Program, TellsWhatReferenceStepsCost) {
  const std::string tells = " takes the reference steps of 0.4 s throughout, about ";
  const std::string quick = "run.integrator = \"adaptive\"";
  write("a.toml", "ecm.radius = \"60 um\"\nrun.duration = \"6 h\"\n");
  const std::string checked = run("check a.toml").out;
  EXPECT_TRUE(checked.starts_with("a.toml: good\na.toml:" + tells)) << checked;
  EXPECT_TRUE(contains(checked, quick)) << checked;
  write("b.toml", "ecm.radius = \"60 um\"\n" + quick + "\n");
  EXPECT_EQ(run("check b.toml").out, "b.toml: good\n");
  write("c.toml", "ecm.radius = \"60 um\"\nrun.duration = \"10 s\"\n");
  EXPECT_EQ(run("check c.toml").out, "c.toml: good\n") << "it costs next to nothing";
  const Ended ran = run("run a.toml -o a --wall-time '0.1 s'");
  EXPECT_TRUE(contains(ran.out, "a.toml:" + tells)) << ran.out;
  EXPECT_FALSE(contains(run("run a.toml -o b --wall-time '0.1 s' --quiet").out, tells));
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
  EXPECT_TRUE(contains(again.err, "mine.toml: exists and is not overwritten")) << again.err;
  EXPECT_EQ(text_of(folder / "mine.toml"), "mine");
  EXPECT_EQ(run("new nowhere/a.toml").code, 5);
}

TEST_F(Program, NewNamesTheSchemaForEditors) {
  ASSERT_EQ(run("new a.toml").code, 0);
  EXPECT_TRUE(text_of(folder / "a.toml").starts_with("#:schema scenario.schema.json\n"));
  EXPECT_EQ(text_of(folder / "scenario.schema.json"), run("list --schema-json").out);
  std::filesystem::create_directory(folder / "sub");
  ASSERT_EQ(run("new sub/b.toml --schema ../mine.json").code, 0);
  EXPECT_TRUE(text_of(folder / "sub/b.toml").starts_with("#:schema ../mine.json\n"));
  EXPECT_FALSE(exists("sub/scenario.schema.json"));
  EXPECT_EQ(run("new d.toml --schema \"$(printf 'a\\nb')\"").code, 2) << "no second line";
  EXPECT_FALSE(exists("d.toml"));
  write("sub/scenario.schema.json", "mine");
  const Ended foreign = run("new sub/c.toml");
  ASSERT_EQ(foreign.code, 0);
  EXPECT_TRUE(contains(foreign.err, "sub/scenario.schema.json: is not the schema of this version")) << foreign.err;
  EXPECT_EQ(text_of(folder / "sub/scenario.schema.json"), "mine") << "a file of somebody else is left alone";
}

TEST_F(Program, AFileSizeLimitIsAnErrorOfOutput) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "ThreadSanitizer writes a file before main";
#endif
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
  const json build = json::parse(run("info --json").out);
  const auto& simd = build.at("cpu").at("simd");
  const bool known = build.at("compiler").get<std::string>().starts_with("GNU 12")
                     && build.at("build_type") == "Release" && build.at("sanitizers").get<std::string>().empty()
                     && std::ranges::find(simd, "fma") != simd.end();
  if (known) { // the build and the processors that the known hash is of
    EXPECT_EQ(found.at("hash"), found.at("known_hash")) << "bring apps/selftest.cpp up to date";
  }
  write("other.sh", "#!/bin/sh\necho before >&2\n'" MATRIGRATE_PROGRAM "' \"$@\"\necho after >&2\n");
  std::filesystem::permissions(folder / "other.sh", std::filesystem::perms::owner_all);
  const Ended with = run("selftest --with ./other.sh");
  EXPECT_EQ(with.code, 0) << with.err;
  EXPECT_TRUE(contains(with.out, "./other.sh: the same bits")) << with.out;
  const Ended none = run("selftest --with /nowhere/matrigrate");
  EXPECT_EQ(none.code, 5);
  EXPECT_TRUE(contains(none.err, "/nowhere/matrigrate: there is no such program")) << none.err;
}

TEST_F(Program, CheckTellsEveryFaultOfEveryFile) {
  write("good.toml", "[run]\nintegrator = \"adaptive\"\n[ecm]\nyoungs_modulus = \"50 Pa\"\n");
  write("bad.toml", "[ecm]\nyoungs_modulu = 1\nradius = \"150 Pa\"\n");
  write("torn.toml", "[ecm]\nyoungs_modulu = 1\nviscosity = 1000 Pa s\n");
  const Ended ended = run("check bad.toml good.toml torn.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.out, "good.toml: good\n");
  EXPECT_TRUE(ended.err.starts_with(
      "bad.toml:2:1: ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?\nbad.toml:3:10: "
      "ecm.radius: \"150 Pa\" is a stress, but a length is expected; write it like \"150 um\"\ntorn.toml:3:18: cannot "
      "be "
      "read as TOML: "))
      << ended.err;
  EXPECT_EQ(run("check good.toml").code, 0);
  const Ended none = run("check bad.toml none.toml good.toml");
  EXPECT_EQ(none.code, 5);
  EXPECT_EQ(none.out, "good.toml: good\n");
  EXPECT_TRUE(none.err.ends_with("none.toml: cannot be read: No such file or directory\n")) << none.err;
  EXPECT_EQ(run("check .").code, 5);
}

TEST_F(Program, CheckRefusesWhatARunRefuses) {
  write("long.toml", "[ecm]\nyoungs_modulus = \"200 Pa\"\n[run]\ntime_step = \"20 s\"\n");
  const Ended step = run("check long.toml");
  EXPECT_EQ(step.code, 3);
  EXPECT_TRUE(step.err.starts_with("long.toml:4:13: run.time_step: a step of 20 s is longer than")) << step.err;
  write("fibres.toml", "[fibres]\narrangement = \"uniaxial\"\ndirection_deg = 13\nhalf_angle_deg = 5\n");
  for (const char* verb : {"check", "run"}) {
    const Ended fibres = run(std::string(verb) + " fibres.toml");
    EXPECT_EQ(fibres.code, 3);
    EXPECT_TRUE(fibres.err.starts_with("fibres.toml:3:17: fibres.direction_deg: no bond of the square lattice"))
        << fibres.err;
    EXPECT_TRUE(contains(fibres.err, "0, 26.57, ")) << fibres.err;
  }
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Program, CheckTellsTheSyntaxErrorOfALargeFile) {
  const std::string large = "preset = \"baseline\"\nreplicates = 2\n#" + std::string(std::size_t{1} << 20U, ' ') + "\n";
  write("torn.toml", large + "[sweep]\necm.youngs_modulus = [\"50 Pa\"\nseed = 1\n");
  const Ended torn = run("check torn.toml");
  EXPECT_EQ(torn.code, 3) << torn.err;
  EXPECT_TRUE(contains(torn.err, "torn.toml:6:") && contains(torn.err, "cannot be read as TOML")) << torn.err;
  write("large.toml", large + "[sweep]\necm.youngs_modulus = [\"50 Pa\"]\n");
  EXPECT_EQ(run("check large.toml").out, "large.toml: good study: 1 points x 2 replicates = 2 runs\n");
}

TEST_F(Program, CheckKnowsAStudy) {
  const std::string head = "preset = \"baseline\"\nreplicates = 2\n[sweep]\n";
  write("two.toml", head + "ecm.youngs_modulus = [\"50 Pa\", \"100 Pa\"]\n");
  EXPECT_EQ(run("check two.toml").out, "two.toml: good study: 2 points x 2 replicates = 4 runs\n");
  const json found = json::parse(run("check --json two.toml").out);
  EXPECT_EQ(found.at("files").at(0).at("kind"), "study");
  for (const char* verb : {"run", "explain"}) {
    const Ended ended = run(std::string(verb) + " two.toml");
    EXPECT_EQ(ended.code, 3);
    EXPECT_TRUE(contains(ended.err, "two.toml: is a study of many runs, and not a scenario; ")) << ended.err;
    EXPECT_TRUE(contains(ended.err, "matrigrate study run two.toml computes it")) << ended.err;
  }
  write("bad.toml", head + "ecm.youngs_modulu = [1]\nrun.time_step = [\"0.4 s\", \"20 s\"]\n");
  EXPECT_EQ(run("check bad.toml").err,
            "bad.toml:4:5: sweep.ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?\n");
  write("bad.toml", head + "run.time_step = [\"0.4 s\", \"20 s\"]\nrun.integrator = [\"reference\"]\n");
  const Ended step = run("check bad.toml");
  EXPECT_EQ(step.code, 3);
  EXPECT_TRUE(step.err.starts_with("bad.toml:4:27: run.time_step: a step of 20 s is longer than")) << step.err;
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

TEST_F(Program, NewWritesTemplatesWithTheirSources) {
  ASSERT_GE(templates().size(), 3U);
  ASSERT_GE(law_files().size(), 8U);
  const std::string help = run("new --help").out;
  const std::string list = run("list").out;
  for (const auto& [option, files] : {std::pair("preset", templates()), std::pair("law", law_files())})
    for (const Template& file : files) {
      const std::string name(file.name);
      const std::string written = fmt::format("{}-{}.toml", option, name);
      ASSERT_EQ(run(fmt::format("new {} --{} {}", written, option, name)).code, 0);
      EXPECT_EQ(text_of(folder / written),
                "#:schema scenario.schema.json" + std::string(file.text.substr(file.text.find('\n'))));
      EXPECT_EQ(run("check " + written).code, 0) << name;
      EXPECT_TRUE(contains(help, name)) << help;
      EXPECT_TRUE(contains(list, "\n  " + name + "  ")) << list;
    }
}

TEST_F(Program, ListShowsWhatShips) {
  const Ended ended = run("list");
  EXPECT_EQ(ended.code, 0);
  for (const char* name : {"\n  baseline ", "\n  soft ", "\n  stiff ", "\n  patch ", "\n  creep ", "\n  stiffness "})
    EXPECT_TRUE(contains(ended.out, name)) << name;
  EXPECT_TRUE(contains(run("list --parameters").out, "| `youngs_modulus` | `\"200 Pa\"` |"));
  EXPECT_TRUE(json::parse(run("list --schema-json").out).contains("properties"));
}

TEST_F(Program, ListKeepsNamesAndDescriptionsApart) {
  const std::string list = run("list").out;
  for (const Preset& preset : presets())
    EXPECT_TRUE(contains(list, fmt::format("\n  {}  ", preset.name))) << preset.name;
  std::size_t column = 0;
  for (const Preset& preset : presets()) {
    const std::size_t start = list.find(fmt::format("\n  {} ", preset.name));
    const std::size_t described = list.find(preset.description, start) - start;
    EXPECT_TRUE(column == 0 || described == column) << preset.name;
    column = described;
  }
}

TEST_F(Program, InfoTellsWhatItIs) {
  const json info = json::parse(run("info --json").out);
  for (const char* key : {"version", "git_hash", "git_dirty", "compiler", "flags", "libraries", "cpu"})
    EXPECT_TRUE(info.contains(key)) << key;
  EXPECT_TRUE(contains(run("info").out, info.at("compiler").get<std::string>()));
}

TEST_F(Program, ExplainTakesTheLawOfInitiation) {
  write("cell.toml", "[ecm]\nradius = \"60 um\"\n");
  const auto wait = [&](const std::string& change) {
    return json::parse(run("explain cell.toml --json --set " + change).out)
        .at("mean_wait_first_protrusion_s")
        .get<double>();
  };
  const double usual = wait("protrusion.initiation_rate=1e-3");
  EXPECT_DOUBLE_EQ(wait("laws.initiation_rate=1e-3"), usual);
  EXPECT_DOUBLE_EQ(wait("laws.initiation_rate=2e-3"), 0.5 * usual);
}

TEST_F(Program, CheckJudgesTheStepAgainWhereTheLawOfFibresDependsOnASweep) {
  write("law.toml",
        "preset = \"baseline\"\nreplicates = 1\n[set]\necm.radius = \"60 um\"\nfibres.arrangement = \"isotropic\"\n"
        "laws.fibre_stiffness = \"eps < 0 ? 0 : 1 + 1000*eps_s\"\n[sweep]\nfibres.onset = [0.01, 1.0, 5.0]\n");
  const Ended ended = run("check law.toml");
  EXPECT_EQ(ended.code, 3) << ended.out;
  EXPECT_TRUE(contains(ended.err + ended.out, "a step of")) << ended.err << ended.out;
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
  EXPECT_EQ(derived.at("steps"), 4320.0);
  EXPECT_TRUE(contains(plain.out, "followed for 6 h in steps of up to 5 s")) << plain.out;
  const std::string reference = run("explain a.toml --set run.integrator=reference").out;
  EXPECT_TRUE(contains(reference, "followed for 6 h in steps of 0.4 s")) << reference;
  const std::string stiff = run("explain a.toml --set 'ecm.youngs_modulus=1 kPa'").out; // 5 s would be too long
  EXPECT_TRUE(contains(stiff, "followed for 6 h in steps of up to 1.25 s")) << stiff;
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
  const Ended ended = run("explain a.toml --set run.integrator=reference --set 'run.time_step=40 s'");
  EXPECT_EQ(ended.code, 0);
  EXPECT_TRUE(contains(ended.out, "WARNING: a step of 40 s is longer than the largest stable one")) << ended.out;
  EXPECT_TRUE(contains(ended.out, " A run of it is refused")) << ended.out;
  EXPECT_FALSE(contains(run("explain a.toml").out, "WARNING"));
  const Ended bad = run("explain a.toml --set run.time_stp=1 --set ecm.radius=3");
  EXPECT_EQ(bad.code, 3);
  EXPECT_EQ(bad.err, "--set: run.time_stp: there is no such parameter; did you mean run.time_step?\n"
                     "--set: ecm.radius: 3 um is out of range; allowed is >= 10 and <= 2000 um\n");
  EXPECT_EQ(run("explain none.toml").code, 5);
}

TEST_F(Program, ExplainTellsOfFibresAndOfTheAdaptiveIntegrator) {
  ASSERT_EQ(run("new a.toml --preset two-protrusions-fibres").code, 0);
  const Ended ended = run("explain a.toml --set run.integrator=reference");
  EXPECT_EQ(ended.code, 0);
  EXPECT_TRUE(contains(ended.out, "8 bonds")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "mean direction 0 degrees")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "run.integrator = \"adaptive\"")) << ended.out;
  const json baseline =
      json::parse(run("explain a.toml --json --set fibres.arrangement=none --set run.integrator=reference").out);
  EXPECT_EQ(baseline.at("adaptive_time_step_s"), 5.0);
  EXPECT_LT(baseline.at("adaptive_wall_time_estimate_s"), 0.5 * baseline.at("wall_time_estimate_s").get<double>());
  EXPECT_TRUE(baseline.at("fibre_mean_direction_deg").is_null());
  const Ended none = run("explain a.toml --set fibres.direction_deg=13 --set fibres.half_angle_deg=5");
  EXPECT_EQ(none.code, 0);
  EXPECT_TRUE(contains(none.out, "WARNING: no bond of the square lattice lies within")) << none.out;
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
        "report none", "export none --fields", "study plan none.toml", "study run none.toml", "study submit none.toml",
        "study status none", "study collect none", "study plan study.toml"}) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 5) << arguments << '\n' << ended.err;
    EXPECT_TRUE(contains(ended.err, "none")) << ended.err;
  }
  EXPECT_EQ(entries(), 1U);
}

} // namespace
} // namespace matrigrate
