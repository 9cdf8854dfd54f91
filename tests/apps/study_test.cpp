#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <tuple>
#include <vector>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Studies of a cell in a small disc, followed for a few steps.
class Study : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"0.002 h\"\n[protrusion]\ninitiation_rate = \"0.01 "
                    "1/s\"\n[output]\ntrack_interval = \"2 s\"\n");
    write_study("\"50 Pa\", \"100 Pa\"");
  }

  void write_study(const std::string& values, int replicates = 2, const std::string& more = "") const {
    write("e.toml", "title = \"Stiffness\"\nscenario = \"s.toml\"\nreplicates = " + std::to_string(replicates)
                        + "\nreadouts = [\"v_migr_abs_um_per_h\", \"n_protrusions\"]\n[sweep]\necm.youngs_modulus = ["
                        + values + "]\n" + more);
  }

  std::string file(const std::string& name) const { return text_of(folder / name); }

  /// Fingerprint of the trajectory of each run, by its folder.
  std::map<std::string, std::string> hashes(const std::string& study) const {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder / study / "runs"))
      if (std::filesystem::exists(entry.path() / "run.json"))
        found[entry.path().filename()] = json::parse(text_of(entry.path() / "run.json")).at("trajectory_hash");
    return found;
  }
};

TEST_F(Study, PlanWritesNothing) {
  const Ended plain = run("study plan e.toml");
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_TRUE(contains(plain.out, "2 points x 2 replicates = 4 runs, into e-study")) << plain.out;
  const json plan = json::parse(run("study plan e.toml --json --jobs 2").out);
  EXPECT_EQ(plan.at("runs").size(), 4U);
  EXPECT_EQ(plan.at("points").at(1).at("settings").at("ecm.youngs_modulus"), "100 Pa");
  for (const char* key : {"wall_time_estimate_s", "memory_estimate_bytes", "disk_estimate_bytes"})
    EXPECT_GT(plan.at(key), 0.0) << key;
  EXPECT_EQ(entries(), 2U);
}

TEST_F(Study, TellsWhichWayMeansLeanWhereRunsEndAtTheRim) {
  write_study("\"200 Pa\"", 2, "[set]\nrun.duration = \"0.1 h\"\nprotrusion.number = 1\n");
  const std::string said = "2 of 2 runs ended at the rim of the matrix (youngs_modulus 200 Pa: 2 of 2): means are of "
                           "the slower cells; take a larger ecm.radius. With ecm.radius = \"60 um\" under [set]";
  const Ended ended = run("study run e.toml --quiet");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_TRUE(contains(ended.out, said)) << ended.out;
  const Ended collected = run("study collect e-study");
  EXPECT_TRUE(contains(collected.out, said)) << collected.out;
  EXPECT_EQ(json::parse(run("study collect e-study --json").out).at("ended_at_rim"), 2);
  EXPECT_EQ(json::parse(run("study run e.toml --json").out).at("ended_at_rim"), 2);
  EXPECT_TRUE(contains(page_data("e-study/report.html"), "2 of 2 runs ended at the rim of the matrix"));
  EXPECT_TRUE(contains(file("e-study/groups.csv"), ",lost_at_rim\n")) << file("e-study/groups.csv");
}

TEST_F(Study, RunsOnceAndAddsWhatIsNew) {
  const Ended first = run("study run e.toml --jobs 2");
  ASSERT_EQ(first.code, 0) << first.out << first.err;
  EXPECT_TRUE(contains(first.out, "4 of 4 runs done, 4 of them now")) << first.out;
  for (const char* name :
       {"study.resolved.toml", "scenario.resolved.toml", "results.csv", "groups.csv", "statistics.csv",
        "correlations.csv", "paths.csv", "msd.csv", "adhesions.csv", "report.html"})
    EXPECT_TRUE(exists(std::string("e-study/") + name)) << name;
  const auto before = hashes("e-study");
  EXPECT_EQ(before.size(), 4U);
  for (const auto& [hash, trajectory] : before)
    EXPECT_EQ(json::parse(file("e-study/runs/" + hash + "/run.json")).at("configuration_hash"), hash);
  const std::string results = file("e-study/results.csv");
  EXPECT_TRUE(results.starts_with("run,label,ecm.youngs_modulus_Pa,replicate,seed,status,")) << results;

  const auto written = std::filesystem::last_write_time(folder / "e-study/study.resolved.toml");
  EXPECT_TRUE(contains(run("study run e.toml").out, "4 of 4 runs done, 0 of them now"));
  EXPECT_EQ(std::filesystem::last_write_time(folder / "e-study/study.resolved.toml"), written);
  EXPECT_EQ(file("e-study/results.csv"), results);
  EXPECT_TRUE(contains(run("study run e-study/study.resolved.toml").out, "0 of them now"));

  write_study("\"100 Pa\", \"200 Pa\", \"50 Pa\"", 3);
  const json more = json::parse(run("study run e.toml --json").out);
  EXPECT_EQ(more.at("runs"), 9);
  EXPECT_EQ(more.at("done_now"), 5) << "a point of three, and a third replicate of the two others";
  const auto after = hashes("e-study");
  for (const auto& [hash, trajectory] : before) EXPECT_EQ(after.at(hash), trajectory);
}

TEST_F(Study, OrderDoesNotMatter) {
  ASSERT_EQ(run("study run e.toml -o there --jobs 1 --quiet").code, 0);
  write_study("\"0.1 kPa\", \"50 Pa\"");
  ASSERT_EQ(run("study run e.toml -o back --jobs 3 --quiet").code, 0);
  EXPECT_EQ(hashes("there"), hashes("back"));
}

TEST_F(Study, AFailingRunIsListedAndTheOthersGoOn) {
  write("e.toml", "scenario = \"s.toml\"\nreplicates = 1\n[[points]]\nlabel = \"good\"\n[[points]]\nlabel = \"bad\"\n"
                  "solver.max_iterations = 1\nsolver.tolerance = 1e-12\n");
  const Ended ended = run("study run e.toml");
  EXPECT_EQ(ended.code, 4) << ended.out << ended.err;
  EXPECT_TRUE(contains(ended.out, "1 of 2 runs done")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "bad, replicate 1")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "was not solved")) << ended.out;
  const json status = json::parse(run("study status e-study --json").out);
  EXPECT_EQ(status.at("count").at("done"), 1);
  EXPECT_EQ(status.at("count").at("failed"), 1);
  EXPECT_TRUE(contains(file("e-study/results.csv"), ",failed,"));
  const json again = json::parse(run("study run e.toml --json").out);
  EXPECT_EQ(again.at("done_now"), 0);
  EXPECT_EQ(again.at("not_done").size(), 1U);
}

TEST_F(Study, CollectsAtAnyTime) {
  EXPECT_EQ(run("study collect e-study").code, 5);
  EXPECT_EQ(run("study status .").code, 5);
  ASSERT_EQ(run("study run e.toml --quiet").code, 0);
  const std::string victim = hashes("e-study").begin()->first;
  std::filesystem::remove_all(folder / "e-study/runs" / victim);
  EXPECT_EQ(run("study collect e-study").code, 5) << "the table holds more than is there";
  std::filesystem::remove(folder / "e-study/results.csv");
  const Ended ended = run("study collect e-study");
  EXPECT_EQ(ended.code, 0);
  EXPECT_TRUE(contains(ended.out, "3 of 4 runs done")) << ended.out;
  EXPECT_TRUE(contains(file("e-study/results.csv"), victim + ",")) << "with the status missing";
  write("e-study/runs/" + hashes("e-study").begin()->first + "/run.json", "{ half");
  EXPECT_TRUE(contains(run("study collect e-study").out, "2 of 4 runs done"));
}

TEST_F(Study, IsGoneOnWithAfterAKill) {
  ASSERT_EQ(run("study run e.toml -o whole --quiet").code, 0);
  write_study("\"50 Pa\", \"100 Pa\"", 6);
  ASSERT_EQ(run("study run e.toml -o reference --jobs 2 --quiet").code, 0);
  for (const char* moment : {"0.05", "0.15", "0.3"}) { // -s KILL: no chance to say goodbye
    const std::string command = "cd '" + folder.string() + "' && timeout -s KILL " + moment
                                + " '" MATRIGRATE_PROGRAM
                                  "' study run e.toml -o whole --jobs 2 --quiet >/dev/null 2>&1";
    EXPECT_NE(std::system(command.c_str()), -1);
  }
  const Ended ended = run("study run e.toml -o whole --jobs 2");
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_TRUE(contains(ended.out, "12 of 12 runs done")) << ended.out;
  EXPECT_EQ(file("whole/results.csv"), file("reference/results.csv"));
}

TEST_F(Study, StopsAtASignal) {
  write("e.toml", "scenario = \"s.toml\"\nreplicates = 4\n[set]\nrun.duration = \"1000 h\"\nprotrusion.initiation_rate "
                  "= 1e-12\n");
  // Told alone, the pool passes it on; a terminal and Slurm tell the whole group, the runs among it, which must not
  // count as being told twice.
  for (const auto& [signal, to, code] :
       {std::tuple<std::string, std::string, int>{"INT", "-$p", 130}, {"TERM", "-$p", 75}, {"TERM", "$p", 75}}) {
    const std::string into = signal + (to == "$p" ? "alone" : "group");
    const std::string telling = "until [ $(ls " + into + "/runs/*/checkpoint.h5 | wc -l) = 2 ]; do sleep 0.01; done; "
                                + "kill -s " + signal + " -- " + to;
    EXPECT_EQ(stopped("study run e.toml --jobs 2 -o " + into, into + "/runs", telling), code);
    EXPECT_TRUE(contains(text_of(base / "out"), "0 of 4 runs done")) << text_of(base / "out");
    const json status = json::parse(run("study status " + into + " --json").out);
    EXPECT_EQ(status.at("count").at("interrupted"), 2);
    EXPECT_EQ(status.at("count").at("missing"), 2);
  }
}

TEST_F(Study, OneRunnerAtATime) {
  write(
      "long.toml",
      "scenario = \"s.toml\"\nreplicates = 1\n[set]\nrun.duration = \"1000 h\"\nprotrusion.initiation_rate = 1e-12\n");
  const std::string others = "'" MATRIGRATE_PROGRAM "' study run long.toml -o here 2>second; echo $? >code; "
                             "'" MATRIGRATE_PROGRAM "' study status here >/dev/null; echo $? >status; kill -s TERM $p";
  EXPECT_EQ(stopped("study run long.toml -o here", "here/runs", others), 75);
  EXPECT_EQ(file("code"), "5\n");
  EXPECT_TRUE(contains(file("second"), "another process is working in this folder")) << file("second");
  EXPECT_EQ(file("status"), "0\n") << "reading is always allowed";
}

TEST_F(Study, GoesOnPastARunWhoseCheckpointsAreBroken) {
  ASSERT_EQ(run("study run e.toml --quiet").code, 0);
  const std::string broken = "e-study/runs/" + hashes("e-study").begin()->first + "/";
  json record = json::parse(file(broken + "run.json"));
  record["status"] = "interrupted";
  write(broken + "run.json", record.dump());
  write(broken + "checkpoint.h5", "nothing");
  std::filesystem::remove(folder / (broken + "checkpoint_prev.h5"));
  write_study("\"50 Pa\", \"100 Pa\", \"200 Pa\"");
  const Ended ended = run("study run e.toml --jobs 1");
  EXPECT_EQ(ended.code, 4) << ended.err;
  EXPECT_TRUE(contains(ended.out, "5 of 6 runs done, 2 of them now")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "checkpoint.h5: is no checkpoint")) << ended.out;
  EXPECT_EQ(file(broken + "checkpoint.h5"), "nothing") << "it is the user's to remove";
}

TEST_F(Study, AFullDiskStopsThePool) {
  ASSERT_EQ(run("study run e.toml -o here --quiet").code, 0);
  write_study("\"50 Pa\", \"100 Pa\"", 4);
  const json plan = json::parse(run("study plan e.toml -o here --json").out);
  for (const json& planned : plan.at("runs")) { // a file where a run's folder should be made
    const std::string hash = planned.at("run");
    if (!exists("here/runs/" + hash)) write("here/runs/" + hash, "in the way");
  }
  const Ended ended = run("study run e.toml -o here --jobs 1");
  EXPECT_EQ(ended.code, 5) << ended.out << ended.err;
  EXPECT_TRUE(contains(ended.out, "not started")) << ended.out;
}

TEST_F(Study, WritesNothingOnAFault) {
  write_study("\"50 um\"", 0, "[set]\necm.radius = \"1 um\"\n");
  const Ended ended = run("study run e.toml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(contains(ended.err, "e.toml:3:14: replicates: 0 is out of range")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "e.toml:6:23: ecm.youngs_modulus: \"50 um\" is a length")) << ended.err;
  EXPECT_TRUE(contains(ended.err, "e.toml:8:14: ecm.radius: \"1 um\" is out of range")) << ended.err;
  EXPECT_EQ(run("study run none.toml").code, 5);
  write_study("\"50 Pa\"", 1, "[[points]]\nrun.time_step = \"3 s\"\n");
  const Ended step = run("study run e.toml");
  EXPECT_EQ(step.code, 3);
  EXPECT_TRUE(contains(step.err, "a step of 3 s is longer than")) << step.err;
  EXPECT_EQ(entries(), 2U);
  EXPECT_EQ(run("study").code, 2);
  EXPECT_EQ(run("study nonsense e.toml").code, 2);
}

TEST_F(Study, RefusesAFolderOfSomethingElse) {
  std::filesystem::create_directory(folder / "mine");
  write("mine/letter", "dear");
  const Ended ended = run("study run e.toml -o mine");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "holds other files")) << ended.err;
}

TEST_F(Study, OverwritesNothing) {
  const auto refused = [&](const std::string& command, const std::vector<std::string>& parts) {
    const Ended ended = run(command);
    EXPECT_EQ(ended.code, 5) << command << ended.err;
    for (const std::string& part : parts) EXPECT_TRUE(contains(ended.err, part)) << command << "\n" << ended.err;
  };
  ASSERT_EQ(run("run s.toml -o r --quiet").code, 0);
  const std::string msd = file("r/msd.csv");
  const std::string report = file("r/report.html");
  for (const char* verb : {"run", "submit"})
    refused(std::string("study ") + verb + " e.toml -o r", {"r: is the folder of a run", "run.json", "-o"});
  EXPECT_EQ(file("r/msd.csv"), msd);
  EXPECT_EQ(file("r/report.html"), report);
  EXPECT_FALSE(exists("r/runs"));
  EXPECT_EQ(run("resume r --hours 0.003 -o b --quiet").code, 0);

  std::filesystem::create_directory(folder / "mine");
  write("mine/.lock", "");
  write("mine/results.csv", "mine");
  refused("study run e.toml -o mine", {"mine: holds other files, and no study: results.csv"});
  EXPECT_EQ(file("mine/results.csv"), "mine");
  EXPECT_FALSE(exists("mine/runs"));

  std::filesystem::create_directories(folder / "early/runs"); // of a pool that was killed early
  write("early/.lock", "");
  EXPECT_EQ(run("study run e.toml -o early --quiet").code, 0);

  std::filesystem::create_directories(folder / "other");
  write("other/e.toml", "scenario = \"../s.toml\"\nseed = 2\nreplicates = 1\n[set]\necm.radius = \"50 um\"\n[sweep]\n"
                        "ecm.youngs_modulus = [50, 70]\n");
  ASSERT_EQ(run("study run e.toml --quiet").code, 0);
  const std::string results = file("e-study/results.csv");
  const std::string known = file("e-study/study.resolved.toml");
  refused("study run other/e.toml",
          {"e-study: holds another study, \"Stiffness\":", "ecm.radius: 40 um there, 50 um here",
           "seed: 1 there, 2 here", "only there: youngs_modulus 100 Pa", "only here: youngs_modulus 70 Pa",
           "-o FOLDER"});
  EXPECT_EQ(file("e-study/results.csv"), results);
  EXPECT_EQ(file("e-study/study.resolved.toml"), known);
  write_study("\"50 Pa\"", 3); // fewer points, more replicates
  EXPECT_EQ(run("study run e.toml --quiet").code, 0);
}

TEST_F(Study, ReproducesNothingOverFilesOfTheUser) {
  std::filesystem::create_directories(folder / "u/stiffness");
  write("u/claims.csv", "mine");
  const std::string command = "reproduce A5 -o u --quiet --replicates 1 --set 'ecm.radius=40 um' --set run.duration=4";
  Ended ended = run(command);
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "u: claims.csv would be replaced")) << ended.err;
  EXPECT_EQ(file("u/claims.csv"), "mine");
  std::filesystem::remove(folder / "u/claims.csv");
  write("u/stiffness/results.csv", "mine");
  ended = run(command);
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "u/stiffness: holds other files")) << ended.err;
  EXPECT_EQ(file("u/stiffness/results.csv"), "mine");
  EXPECT_FALSE(exists("u/stiffness/runs"));
}

TEST_F(Study, TimesThatAreNoShortDecimalOfTheirUnitAreNumbers) {
  write("times.toml", "scenario = \"s.toml\"\nreplicates = 1\n[sweep]\nrun.duration = [\"7 s\", \"3.6 s\"]\n");
  const Ended ended = run("study run times.toml --quiet");
  ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
  EXPECT_TRUE(contains(file("times-study/results.csv"), ",0.0019444444444444444,")) << file("times-study/results.csv");
  EXPECT_TRUE(contains(file("times-study/results.csv"), ",0.001,")) << "of an hour";
  EXPECT_TRUE(exists("times-study/report.html"));
}

TEST_F(Study, FieldsCountFromItsFolderAndTheirContentDecides) {
  const std::string grid = "x_um,y_um,E_Pa\n-60,-60,100\n60,-60,300\n-60,60,100\n60,60,300\n";
  for (const char* there : {"A", "A/other"}) std::filesystem::create_directory(folder / there);
  write("A/E.csv", grid);
  write("A/other/E.csv", "x_um,y_um,E_Pa\n-60,-60,400\n60,-60,400\n-60,60,400\n60,60,400\n");
  write("A/e.toml",
        "scenario = \"../s.toml\"\nreplicates = 1\n[sweep]\necm.fields.youngs_modulus = [\"E.csv\", \"200 + x\"]\n");
  write("A/set.toml", "scenario = \"../s.toml\"\nreplicates = 1\n[set]\necm.fields.youngs_modulus = \"E.csv\"\n");
  write("A/conditions.toml",
        "scenario = \"../s.toml\"\nreplicates = 1\n[[conditions]]\nlabel = \"plain\"\n[[conditions]]\n"
        "label = \"grid\"\n[conditions.ecm.fields]\nyoungs_modulus = \"E.csv\"\n");
  for (const std::string name : {"e", "set", "conditions"}) {
    ASSERT_EQ(run("study run A/" + name + ".toml -o " + name + " --quiet").code, 0) << name << text_of(base / "err");
    ASSERT_EQ(run("-h >/dev/null; cd A/other; '" MATRIGRATE_PROGRAM "' study run ../" + name + ".toml -o ../../" + name
                  + "2 --quiet")
                  .code,
              0)
        << name << text_of(base / "err");
    EXPECT_EQ(hashes(name), hashes(name + "2"));
  }
  EXPECT_TRUE(contains(file("e/study.resolved.toml"), "E.csv hash="));
  EXPECT_TRUE(contains(file("e/results.csv"), ",youngs_modulus E.csv,")) << file("e/results.csv");
  const std::string results = file("e/results.csv");
  write("A/E.csv", grid.substr(0, grid.size() - 4) + "301\n");
  for (const std::string name : {"e", "set"}) {
    const Ended changed = run("study run A/" + name + ".toml -o " + name);
    EXPECT_EQ(changed.code, 5) << changed.err;
    std::size_t fingerprints = 0;
    for (std::size_t at = changed.err.find(" hash="); at != std::string::npos; at = changed.err.find(" hash=", at + 1))
      ++fingerprints;
    EXPECT_EQ(fingerprints, 2U) << changed.err;
  }
  EXPECT_EQ(run("study run e/study.resolved.toml").code, 3) << "it names the content";
  EXPECT_EQ(file("e/results.csv"), results);
  EXPECT_EQ(run("study run A/e.toml -o new --quiet").code, 0);
  write("A/e.toml", "scenario = \"../s.toml\"\nreplicates = 1\n[sweep]\necm.fields.youngs_modulus = [\"none.csv\"]\n");
  const Ended missing = run("study plan A/e.toml");
  EXPECT_EQ(missing.code, 3);
  EXPECT_TRUE(contains(missing.err, "A/e.toml:4:30: ecm.fields.youngs_modulus: ")) << missing.err;
}

TEST_F(Study, WithoutSlurmTheScriptIsKept) {
  const std::string command = "cd '" + folder.string()
                              + "' && PATH=/nowhere '" MATRIGRATE_PROGRAM
                                "' study submit e.toml --throttle 2 --time 1:00:00 2>'"
                              + (base / "err").string() + "'";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 5);
  EXPECT_TRUE(contains(text_of(base / "err"), "sbatch was not found")) << text_of(base / "err");
  const std::string script = file("e-study/submit.sh");
  for (const char* line : {"#SBATCH --array=0-3%2", "#SBATCH --requeue", "#SBATCH --time=1:00:00"})
    EXPECT_TRUE(contains(script, line)) << script;
}

TEST_F(Study, StatusTellsHowFarRunsAre) {
  write("s.toml", "[ecm]\nradius = \"40 um\"\n[output]\ntrack_interval = \"2 s\"\n");
  stopped("study run e.toml --jobs 2", "e-study/study.resolved.toml",
          "cd '" + folder.string()
              + "'; M='" MATRIGRATE_PROGRAM "'; until \"$M\" study status e-study --json | grep -q '\"left_s\": "
                "[0-9]'; do sleep 0.05; kill -0 $p || break; "
                "done; \"$M\" study status e-study >status; \"$M\" study status e-study --json >status.json; kill -s "
                "INT $p");
  const json status = json::parse(file("status.json"));
  ASSERT_FALSE(status.at("running").empty());
  EXPECT_GT(status.at("running").at(0).at("share").get<double>()
                + status.at("running").back().at("share").get<double>(),
            0.0);
  EXPECT_GT(status.at("left_s").get<double>(), 0.0);
  EXPECT_EQ(status.at("count").at("running"), status.at("running").size());
  for (const char* part : {"running     youngs_modulus", " %, about ", " left\n", "all runs: about ", " at a time\n"})
    EXPECT_TRUE(contains(file("status"), part)) << part << file("status");
  const json after = json::parse(run("study status e-study --json").out);
  EXPECT_TRUE(after.at("running").empty());
  EXPECT_TRUE(after.at("left_s").is_null()) << "nothing runs";
}

TEST_F(Study, OfSeveralCellsInAFieldHasMeansAndAGroup) {
  write("two.toml", file("s.toml") + "[[cells]]\nx = -16\ny = 0\n[[cells]]\nx = 16\ny = 0\n");
  write("e.toml",
        "scenario = \"two.toml\"\nreplicates = 1\n[set]\necm.radius = \"60 um\"\n[[points]]\nlabel = \"gel\"\n"
        "[[points]]\nlabel = \"hole\"\necm.fields.f_degr = \"y < -40 ? 0 : 1\"\n");
  const Ended ended = run("study run e.toml --quiet");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string results = file("e-study/results.csv");
  EXPECT_TRUE(contains(results, ",parting_index,share_in_contact,nearest_um,order\n")) << results;
  EXPECT_TRUE(contains(results, ",32.")) << "distance of the cells: " << results;
  EXPECT_TRUE(contains(file("e-study/paths.csv"), ",cell,point\n"));
  EXPECT_TRUE(contains(file("e-study/report.html"), "-40 ? 0 : 1"));
}

TEST_F(Study, ShippedStudiesAreKnownByName) {
  EXPECT_TRUE(contains(run("study plan two-cells").out, "= 24 runs, into two-cells-study"));
  EXPECT_EQ(run("study plan three-cells").code, 5) << "no such file and no such study";
}

TEST_F(Study, CollectPrintsATable) {
  write_study("\"50 Pa\", \"100 Pa\"", 1, "[set]\nrun.time_step = \"0.4 s\"\n");
  ASSERT_EQ(run("study run e.toml --quiet").code, 0);
  const std::string text = run("study collect e-study").out;
  EXPECT_TRUE(contains(text, "\n  point                  n ")) << text;
  EXPECT_TRUE(contains(text, "  youngs_modulus 50 Pa   1 ")) << text;
  EXPECT_FALSE(contains(text, "nan")) << text;
  EXPECT_FALSE(contains(text, "[-, -]")) << text;
}

TEST_F(Study, CollectPrintsNoPOfTwoRuns) {
  const auto row = [&](int replicates) { // of the only pair: difference, interval, p, Holm's p and more
    write_study("\"50 Pa\", \"100 Pa\"", replicates);
    EXPECT_EQ(run("study run e.toml --quiet").code, 0);
    std::string text = run("study collect e-study").out;
    const std::string pair = "  youngs_modulus 50 Pa  youngs_modulus 100 Pa ";
    EXPECT_EQ(contains(text, "A p needs at least 3 runs at each point"), replicates < 3) << text;
    std::istringstream remarks(text.substr(std::min(text.find("Holm's p is corrected"), text.size())));
    for (std::string line; std::getline(remarks, line);) EXPECT_LE(line.size(), 80U) << "wider than a terminal";
    const std::size_t begin = text.find(pair);
    if (begin == std::string::npos) return text;
    return text.substr(begin + pair.size(), text.find('\n', begin) - begin - pair.size());
  };
  const std::string none = "  -         -  ";
  const std::string two = row(2);
  EXPECT_TRUE(contains(two, " to ")) << "the interval stays: " << two;
  EXPECT_TRUE(contains(two, none)) << two;
  EXPECT_FALSE(contains(row(3), none));
}

TEST_F(Study, PlanOfManyPointsLooksForWarningsAtSome) {
  std::string values;
  for (int k = 0; k < 201; ++k) values += (k > 0 ? ", \"" : "\"") + std::to_string(100 + k) + " Pa\"";
  write_study(values);
  const json plan = json::parse(run("study plan e.toml --json").out);
  EXPECT_EQ(plan.at("points_looked_at_for_warnings"), 200);
  EXPECT_EQ(plan.at("points").size(), 201U);
  for (const json& point : plan.at("points"))
    EXPECT_EQ(point.at("run_time_estimate_s"), plan.at("points").at(0).at("run_time_estimate_s"));
  EXPECT_TRUE(contains(run("study plan e.toml").out, "looked for at 200 of the 201 points"));
}

TEST_F(Study, ReproduceRunsAndJudges) {
  const std::string tiny = " --set 'ecm.radius=40 um' --set 'run.duration=0.002 h' --replicates 2";
  const Ended ended = run("reproduce A5" + tiny);
  EXPECT_EQ(ended.code, 4) << ended.out << ended.err;
  EXPECT_TRUE(contains(ended.out, "A5  undecided (not the paper's runs)\n")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "Not run as the paper ran it")) << ended.out;
  for (const char* name : {"claims-A5.csv", "report-A5.html", "stiffness/results.csv"})
    EXPECT_TRUE(exists(std::string("reproduce/") + name)) << name;
  EXPECT_TRUE(file("reproduce/claims-A5.csv").starts_with("id,sentence,published,ours,statistic,verdict,caveat\n"));
  EXPECT_TRUE(file("reproduce/claims-A5.csv").ends_with(",undecided,not the paper's runs\n"));
  const json page = json::parse(page_data("reproduce/report-A5.html"));
  EXPECT_TRUE(page.at("facts").at(0).at("value").get<std::string>().starts_with(
      "matrigrate reproduce A5 --set 'ecm.radius=40 um'"));
  EXPECT_TRUE(contains(page.at("setting"), "these are no verdicts on the paper"));
  EXPECT_EQ(page.at("statements").at(0).at("verdict"), "undecided");
  EXPECT_EQ(page.at("statements").at(0).at("caveat"), "not the paper's runs");
  EXPECT_EQ(page.at("studies").at(0).at("name"), "stiffness");
  EXPECT_EQ(page.at("studies").at(0).at("study").at("runs").size(), 10U);
  EXPECT_TRUE(exists("reproduce/stiffness/shapes.csv"));
  const std::string results = file("reproduce/stiffness/results.csv");
  const json again = json::parse(run("reproduce A2 --json" + tiny).out);
  EXPECT_FALSE(again.at("as_published").get<bool>());
  EXPECT_EQ(again.at("rows").at(0).at("id"), "A2");
  EXPECT_EQ(again.at("rows").at(0).at("caveat"), "not the paper's runs");
  EXPECT_EQ(file("reproduce/stiffness/results.csv"), results) << "rows share their runs";
  EXPECT_EQ(run("reproduce A9").code, 2);
  EXPECT_EQ(run("reproduce E5" + tiny).code, 4);
  EXPECT_EQ(run("reproduce A --set ecm.radius=1 -o elsewhere").code, 3);
  EXPECT_FALSE(exists("elsewhere"));
}

} // namespace
} // namespace matrigrate
