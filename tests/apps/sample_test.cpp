#include "program.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace matrigrate {
namespace {

using nlohmann::json;

const std::string small =
    "sample ecm.radius=\"60 um\" run.integrator=adaptive protrusion.initiation_rate=0.01 --hours 0.05 ";

TEST_F(Program, SamplePrintsTheReadoutsOfARun) {
  const Ended ended = run(small + "--seed 5");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json sample = json::parse(ended.out);
  EXPECT_EQ(sample["seed"], 5);
  EXPECT_EQ(sample["readouts"]["duration_s"], 180.0);
  EXPECT_TRUE(sample["readouts"]["share_2_or_3_protrusions"].is_number());
  EXPECT_TRUE(sample["readouts"]["tau_prot_min"].is_null()) << "not defined in three minutes";
  EXPECT_FALSE(sample.contains("distance"));
  EXPECT_EQ(entries(), 0U) << "nothing is kept";
  EXPECT_EQ(json::parse(run(small + "run.seed=5").out), sample);
}

TEST_F(Program, SampleDrawsASeedEachTime) {
  const json a = json::parse(run(small).out);
  const json b = json::parse(run(small).out);
  EXPECT_NE(a["seed"], b["seed"]);
  const json again = json::parse(run(small + "--seed " + a["seed"].dump()).out);
  EXPECT_EQ(again["readouts"], a["readouts"]);
}

TEST_F(Program, SampleTellsTheDistanceFromTargets) {
  write("t.toml",
        "title = \"as of a study\"\n[[targets]]\nreadout = \"duration_s\"\nvalue = 170\nerror = 5\nweight = 3\n"
        "[[targets]]\nreadout = \"n_protrusions\"\nlow = -9\nhigh = 1000\nerror = 1\n");
  const json sample = json::parse(run(small + "--targets t.toml").out);
  EXPECT_DOUBLE_EQ(sample["targets"][0]["z"], 2.0);
  EXPECT_DOUBLE_EQ(sample["targets"][1]["z"], 0.0) << "within the range";
  EXPECT_DOUBLE_EQ(sample["distance"], std::sqrt(3.0 * 4.0 / 4.0));
  write("u.toml", "[[targets]]\nreadout = \"tau_prot_min\"\nvalue = 1\nerror = 5\n");
  const json undefined = json::parse(run(small + "--targets u.toml").out);
  EXPECT_TRUE(undefined["distance"].is_null());
}

TEST_F(Program, SampleWritesWhereAnExternalModelOfPyabcWantsIt) {
  write("loc", "");
  const Ended ended = run("sample 'ecm.radius=60 ' 'run.integrator=adaptive ' --hours 0.02 target=loc");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "");
  const double duration = json::parse(text_of(folder / "loc"))["readouts"]["duration_s"];
  EXPECT_DOUBLE_EQ(duration, 72.0);
  const Ended again = run("sample target=loc");
  EXPECT_EQ(again.code, 5);
  EXPECT_EQ(again.err, "matrigrate: loc: holds something already\n");
}

TEST_F(Program, SampleTellsAllFaultsAtOnce) {
  write("t.toml",
        "[[targets]]\nreadout = \"f_mat\"\nvalue = 1\nerror = 0\n[[targets]]\nreadout = \"speed\"\nvalue = 1\n");
  const Ended ended = run("sample ecm.radius=-1 nothing=2 --targets t.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.out, "");
  for (const std::string words : {"ecm.radius: ", "nothing: ", "t.toml:4:9: targets.error: 0 is out of range",
                                  "t.toml:6:11: targets.readout", "t.toml:5:1: targets.error: is missing"})
    EXPECT_TRUE(ended.err.find(words) != std::string::npos) << words << "\n" << ended.err;
  write("none.toml", "title = \"no targets\"\n");
  const Ended none = run("sample --targets none.toml");
  EXPECT_EQ(none.code, 3);
  EXPECT_TRUE(none.err.find("none.toml: targets: there are none; write [[targets]]") != std::string::npos) << none.err;
  EXPECT_EQ(run("sample --targets nowhere.toml").code, 5);
  EXPECT_EQ(run("sample --preset sotf").code, 2);
  EXPECT_EQ(run("sample --preset soft --scenario f.toml").code, 2);
}

TEST_F(Program, SampleRefusesWhatIsGivenTwice) {
  write("loc", "");
  const Ended ended = run("sample ecm.radius=60 ecm.youngs_modulus=100 ecm.radius=70 target=loc target=loc");
  EXPECT_EQ(ended.code, 2);
  EXPECT_EQ(ended.err, "matrigrate: ecm.radius, target: is given more than once\n");
  EXPECT_TRUE(contains(run("sample run.seed=1 --seed 2").err, "run.seed: is given more than once"));
  EXPECT_TRUE(contains(run("sample run.duration=60 --hours 2").err, "run.duration: is given more than once"));
}

TEST_F(Program, SeedsBeyondTheirRangeAreCalledThat) {
  EXPECT_TRUE(contains(run("sample --seed -1").err, "--seed: run.seed: -1 is out of range; allowed is >= 0"));
  EXPECT_TRUE(contains(run("sample run.seed=18446744073709551616").err,
                       "run.seed: 18446744073709551616 is out of range; allowed is >= 0"));
}

TEST_F(Program, SampleNamesTheFolderThatItCannotWorkIn) {
  const Ended ended = run("sample", "env' TMPDIR=/nowhere '" MATRIGRATE_PROGRAM);
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "matrigrate: /nowhere: is no folder to work in: ")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "; TMPDIR names another one")) << ended.err;
}

TEST_F(Program, SampleSaysWhereThereIsNoRoomToWork) {
  const Ended ended = run("sample ecm.radius=\"40 um\" --hours 0.01",
                          "bash' -c 'ulimit -f 150; TMPDIR=. exec \"$0\" \"$@\"' '" MATRIGRATE_PROGRAM); // kB a file
  EXPECT_EQ(ended.code, 5);
  EXPECT_EQ(ended.out, "");
  EXPECT_TRUE(contains(ended.err, "checkpoint")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "nothing of it is kept; TMPDIR names another folder to work in\n")) << ended.err;
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Program, SampleThatIsStoppedPromisesNothing) {
  ::setenv("TMPDIR", folder.c_str(), 1);
  const int code = stopped("sample ecm.radius=60 run.integrator=adaptive --hours 100", ".",
                           "while ! ls matrigrate.*/tracks.csv && kill -0 $p; do sleep 0.01; done; kill -TERM $p");
  ::unsetenv("TMPDIR");
  EXPECT_EQ(code, 75);
  const std::string told = text_of(base / "err");
  EXPECT_TRUE(contains(told, "stopped by a signal to terminate; nothing of it is kept")) << told;
  EXPECT_FALSE(contains(told, "resume")) << told;
  EXPECT_EQ(entries(), 0U);
}

TEST_F(Program, SampleEndsAsItsRunDoes) {
  const Ended ended = run("sample ecm.radius=\"40 um\" ecm.youngs_modulus=50 protrusion.initiation_rate=0.002 "
                          "run.integrator=adaptive --hours 0.5 --seed 1");
  EXPECT_EQ(ended.code, 4) << ended.out;
  EXPECT_EQ(ended.out, "");
  EXPECT_NE(ended.err, "");
}

} // namespace
} // namespace matrigrate
