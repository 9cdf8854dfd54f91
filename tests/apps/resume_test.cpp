#include "program.hpp"
#include "store/field_file.hpp"
#include "store/saved_frames.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <utility>
#include <vector>

namespace matrigrate {
namespace {

using nlohmann::json;

/// A small migration of some 150 steps, with rows and checkpoints at times that do not coincide.
class Resume : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[protrusion]\ninitiation_rate = \"0.001 1/s\"\n[output]\n"
                    "track_interval = \"4 s\"\ncheckpoint_interval = \"7 s\"\n"
                    "kept_checkpoint_interval = \"12 s\"\nfield_interval = \"9 s\"\n[run]\nduration = \"60 s\"\n");
  }
  json record(const std::string& of) const { return json::parse(text_of(folder / of / "run.json")); }

  /// Starts a run in `into`, waits for one of its files and a little longer, and ends it with a signal; once more if it
  /// was done before the signal came, which a busy machine may bring about.
  /// @return  its exit code
  int stop(const std::string& into, const std::string& signal, const std::string& options = "",
           const std::string& file = "checkpoint.h5", double later = 0.0) const {
    int code = 0;
    for (int attempt = 0; attempt < 20 && code == 0; ++attempt) {
      std::filesystem::remove_all(folder / into);
      code = stopped(fmt::format("run s.toml -o {} {} --quiet", into, options), into + "/" + file,
                     fmt::format("sleep {}; kill -s {} $p", later, signal));
    }
    return code;
  }

  void expect_same_results(const std::string& a, const std::string& b) const {
    EXPECT_EQ(record(a).at("trajectory_hash"), record(b).at("trajectory_hash"));
    for (const char* file : {"tracks.csv", "health.csv", "protrusions.csv", "summary.json", "msd.csv",
                             "scenario.resolved.toml", "fields.h5", "fields.xdmf"})
      EXPECT_EQ(text_of(folder / a / file), text_of(folder / b / file)) << file;
  }
};

TEST_F(Resume, GoesOnToTheSameBits) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  for (const auto& [signal, code] : {std::pair<std::string, int>{"TERM", 75}, {"USR1", 75}, {"INT", 130}}) {
    ASSERT_EQ(stop(signal, signal), code) << signal;
    EXPECT_EQ(record(signal).at("status"), "interrupted");
    EXPECT_TRUE(contains(record(signal).at("reason"), "matrigrate resume " + signal)) << record(signal).at("reason");
    const Ended ended = run("resume " + signal);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(record(signal).at("status"), "done");
    EXPECT_EQ(record(signal).at("lineage").size(), 1U);
    EXPECT_EQ(record(signal).at("lineage").at(0).at("event"), "resumed");
    expect_same_results(signal, "whole");
  }
}

TEST_F(Resume, GoesOnAfterBeingKilled) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  for (const double later : {0.0, 0.1, 0.2}) {
    const std::string here = fmt::format("killed-{}", later);
    stop(here, "KILL", "", "tracks.csv", later);
    const Ended ended = run("run s.toml --quiet -o " + here); // `run` into its own folder resumes as well
    ASSERT_EQ(ended.code, 0) << ended.err;
    expect_same_results(here, "whole");
  }
}

TEST_F(Resume, WritesTheLastFilesAgainWhereItWasKilledAmongThem) {
  const std::string options = " --set 'run.duration=122 s' --quiet"; // not when a row or a frame is due
  ASSERT_EQ(run("run s.toml -o here" + options).code, 0);
  std::filesystem::copy(folder / "here", folder / "whole", std::filesystem::copy_options::recursive);
  json changed = record("here");
  changed["status"] = "running";
  write("here/run.json", changed.dump());
  std::filesystem::remove(folder / "here/report.html");
  ASSERT_EQ(run("run s.toml -o here" + options).code, 0);
  EXPECT_TRUE(exists("here/report.html"));
  for (const char* file : {"tracks.csv", "health.csv", "protrusions.csv", "summary.json", "fields.h5", "fields.xdmf"})
    EXPECT_EQ(text_of(folder / "here" / file), text_of(folder / "whole" / file)) << file;
}

TEST_F(Resume, StopsAtTheLimitOfWallTime) {
  ASSERT_EQ(run("run s.toml -o here --hours 24 --wall-time '0.2 s' --quiet").code, 75);
  EXPECT_TRUE(contains(record("here").at("reason"), "limit of wall time"));
  EXPECT_EQ(run("run s.toml --wall-time '2 um'").code, 2);
  EXPECT_EQ(run("run s.toml --wall-time soon").code, 2);
}

TEST_F(Resume, LeavesWhatIsDone) {
  ASSERT_EQ(run("run s.toml -o here --quiet").code, 0);
  const std::string before = text_of(folder / "here/run.json");
  for (const char* again : {"run s.toml -o here", "run s.toml -o here --threads 2", "resume here"}) {
    const Ended ended = run(again);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(contains(ended.out, "done already")) << ended.out;
    EXPECT_TRUE(contains(ended.out, "open here/report.html")) << ended.out;
  }
  EXPECT_EQ(json::parse(run("resume here --json").out).at("status"), "done");
  EXPECT_EQ(text_of(folder / "here/run.json"), before);
  EXPECT_EQ(run("run s.toml -o here --seed 2").code, 5) << "another run";
}

TEST_F(Resume, RefusesDamagedCheckpointsAndOffersTheOneBefore) {
  stop("here", "KILL", "", "checkpoints/t_00012s.h5");
  if (!exists("here/checkpoint.h5")) // killed between two renames
    std::filesystem::copy_file(folder / "here/checkpoint_prev.h5", folder / "here/checkpoint.h5");
  const std::string whole = text_of(folder / "here/checkpoint.h5");
  const auto refused = [&](const std::string& bytes, const std::string& why) {
    std::ofstream(folder / "here/checkpoint.h5", std::ios::binary) << bytes;
    const Ended ended = run("resume here");
    EXPECT_EQ(ended.code, 5);
    EXPECT_TRUE(contains(ended.err, why)) << ended.err;
    EXPECT_TRUE(contains(ended.err, "--previous")) << ended.err;
  };
  std::string changed = whole;
  changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 1);
  refused(changed, "has been changed");
  refused(whole.substr(0, whole.size() / 3), "is cut short");
  refused("nonsense", "is no checkpoint");
  std::string other = whole;
  other[22] = '8';
  refused(other, "format 8");
  EXPECT_EQ(run("resume here --previous --quiet").code, 0);
  EXPECT_EQ(record("here").at("status"), "done");
}

TEST_F(Resume, RefusesTheCheckpointOfAnotherScenario) {
  ASSERT_EQ(run("run s.toml -o a --quiet").code, 0);
  stop("b", "TERM", "--seed 2");
  std::filesystem::copy_file(folder / "a/checkpoint.h5", folder / "b/checkpoint.h5",
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove(folder / "b/checkpoint_prev.h5");
  const Ended ended = run("resume b");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "another scenario")) << ended.err;
}

TEST_F(Resume, SaysWhatThereIsNot) {
  EXPECT_EQ(run("resume nowhere").code, 5);
  std::filesystem::create_directory(folder / "empty");
  const Ended ended = run("resume empty");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "no checkpoint")) << ended.err;
  EXPECT_EQ(run("resume empty -o other").code, 2);
  write("empty/study.resolved.toml", "");
  EXPECT_TRUE(contains(run("resume empty").err, "empty: is the folder of a study; matrigrate study run"))
      << "what helps";
}

TEST_F(Resume, Branches) {
  ASSERT_EQ(run("run s.toml -o trunk --quiet").code, 0);
  const std::string trunk = text_of(folder / "trunk/run.json");
  const Ended stiff = run("resume trunk --at '12 s' --set ecm.youngs_modulus='400 Pa' -o stiff --quiet");
  ASSERT_EQ(stiff.code, 0) << stiff.err;
  EXPECT_EQ(text_of(folder / "trunk/run.json"), trunk);
  const json lineage = record("stiff").at("lineage");
  ASSERT_EQ(lineage.size(), 1U);
  EXPECT_EQ(lineage.at(0).at("event"), "branched");
  EXPECT_EQ(lineage.at(0).at("at_s"), 12.0);
  EXPECT_EQ(lineage.at(0).at("set").at(0), "ecm.youngs_modulus=400 Pa");
  EXPECT_TRUE(contains(text_of(folder / "stiff/scenario.resolved.toml"), "youngs_modulus = \"400 Pa\""));
  const std::string with = text_of(folder / "stiff/tracks.csv");
  const std::string without = text_of(folder / "trunk/tracks.csv");
  const std::size_t common = without.find(",12,") == std::string::npos ? 0 : without.find("\n1,16,");
  EXPECT_EQ(with.substr(0, common), without.substr(0, common)) << "the history is the trunk's";
  EXPECT_NE(with, without);
}

TEST_F(Resume, BranchesBetweenCheckpointsAsIfOneStoodThere) {
  ASSERT_EQ(run("run s.toml -o trunk --quiet").code, 0);
  ASSERT_EQ(run("resume trunk --at '10 s' --seed 5 -o a --quiet").code, 0);
  std::filesystem::remove_all(folder / "trunk/checkpoints");
  std::filesystem::remove(folder / "trunk/checkpoint_prev.h5");
  ASSERT_EQ(run("resume trunk --at '10 s' --seed 5 -o b --quiet").code, 0) << "from the start";
  expect_same_results("a", "b");
  ASSERT_EQ(run("resume trunk --hours 0.02 -o longer --quiet").code, 0);
  ASSERT_EQ(run("run s.toml --hours 0.02 -o whole --quiet").code, 0);
  EXPECT_EQ(text_of(folder / "longer/tracks.csv"), text_of(folder / "whole/tracks.csv"));
}

TEST_F(Resume, BranchesFromTheStartWithTheFirstRow) {
  const std::string adaptive = "--set run.integrator=adaptive --set 'run.time_step=2 s' --quiet";
  ASSERT_EQ(run("run s.toml -o trunk " + adaptive).code, 0);
  std::filesystem::remove_all(folder / "trunk/checkpoints");
  std::filesystem::remove(folder / "trunk/checkpoint_prev.h5");
  ASSERT_EQ(run("resume trunk --at '20 s' --hours 0.02 -o longer --quiet").code, 0);
  ASSERT_EQ(run("run s.toml --hours 0.02 -o whole " + adaptive).code, 0);
  expect_same_results("longer", "whole");
}

TEST_F(Resume, BranchesFromAWholeCheckpointOrSaysSo) {
  ASSERT_EQ(run("run s.toml -o trunk --quiet").code, 0);
  std::string bytes = text_of(folder / "trunk/checkpoint.h5");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  write("trunk/checkpoint.h5", bytes);
  const Ended refused = run("resume trunk --hours 0.02 -o no");
  EXPECT_EQ(refused.code, 5);
  EXPECT_TRUE(contains(refused.err, "--previous")) << refused.err;
  EXPECT_FALSE(exists("no"));
  ASSERT_EQ(run("resume trunk --hours 0.02 --previous -o longer --quiet").code, 0);
  EXPECT_GT(record("longer").at("lineage").at(0).at("at_s"), 0.0);
  const Ended warned = run("resume trunk --hours 0.02 --at '12 s' -o at --quiet");
  EXPECT_EQ(warned.code, 0);
  EXPECT_TRUE(contains(warned.err, "checkpoint.h5: has been changed")) << warned.err;
}

TEST_F(Resume, KeepsTheNameAndTheCommandOfTheStart) {
  const auto facts = [&](const std::string& of) {
    const json page = json::parse(page_data(of + "/report.html"));
    std::string text;
    for (const json& fact : page.at("facts"))
      text += fact.at("name").get<std::string>() + ": " + fact.at("value").get<std::string>() + "\n";
    return text;
  };
  ASSERT_EQ(stop("here", "TERM"), 75);
  ASSERT_EQ(run("resume here --quiet").code, 0);
  const std::string command = "command: matrigrate run s.toml -o here --quiet\n";
  EXPECT_TRUE(contains(facts("here"), "scenario: s\n")) << facts("here");
  EXPECT_TRUE(contains(facts("here"), command)) << facts("here");
  ASSERT_EQ(run("resume here --seed 2 --at '12 s' -o b --quiet").code, 0);
  ASSERT_EQ(run("report b").code, 0);
  EXPECT_TRUE(contains(facts("b"), "scenario: s\n")) << facts("b");
  EXPECT_TRUE(contains(facts("b"), command)) << facts("b");
  EXPECT_TRUE(contains(facts("b"), "branched by: matrigrate resume here --seed 2 --at '12 s' -o b --quiet\n"));
  EXPECT_EQ(json::parse(page_data("b/report.html")).at("title"), "s: E = 200 Pa, seed 2");
}

TEST_F(Resume, RefusesBranchesThatCannotBe) {
  ASSERT_EQ(run("run s.toml -o trunk --quiet").code, 0);
  const Ended ended = run("resume trunk --set ecm.radius=60 --set cell.particles=200");
  EXPECT_EQ(ended.code, 3);
  for (const char* key : {"ecm.radius", "cell.particles"}) EXPECT_TRUE(contains(ended.err, key)) << ended.err;
  EXPECT_EQ(run("resume trunk --at '70 s'").code, 3) << "beyond the end";
  EXPECT_EQ(run("resume trunk --at '10.1 s'").code, 3) << "between steps";
  EXPECT_EQ(run("resume trunk --set run.sed=1").code, 3);
  EXPECT_TRUE(contains(run("resume trunk --hours -1").err, "--hours: run.duration"));
  const Ended taken = run("resume trunk --at '12 s' --seed 2 -o trunk");
  EXPECT_EQ(taken.code, 5);
  EXPECT_TRUE(contains(taken.err, "trunk: exists and is not empty; choose another folder with -o\n")) << taken.err;
  EXPECT_FALSE(exists("trunk-branch"));
}

TEST_F(Resume, BranchesFromACheckpointBetweenMultiplesOfTheStep) {
  ASSERT_EQ(run("run s.toml -o odd --quiet --set run.integrator=adaptive --set run.duration='11 s'").code, 0);
  ASSERT_EQ(record("odd").at("t_s"), 11.0);
  const Ended longer = run("resume odd --hours 0.01 -o longer --quiet");
  EXPECT_EQ(longer.code, 0) << longer.err;
  EXPECT_EQ(record("longer").at("lineage").back().at("at_s"), 15.0);
  ASSERT_EQ(run("run s.toml -o whole --quiet --set run.integrator=adaptive --hours 0.01").code, 0);
  EXPECT_EQ(text_of(folder / "longer/protrusions.csv"), text_of(folder / "whole/protrusions.csv"));
  const Ended between = run("resume odd --at '7 s' -o none");
  EXPECT_EQ(between.code, 3);
  EXPECT_TRUE(contains(between.err, "--at: 7 s is no multiple of run.time_step, 5 s; --at \"10 s\" is")) << between.err;
}

TEST_F(Resume, EndsAtItsDurationWithinAStepAndGoesOnAsIfItHadNot) {
  const std::string reference = " --quiet";
  const std::string adaptive = " --quiet --set run.integrator=adaptive --set 'run.time_step=5 s'";
  for (const std::string& options : {reference, adaptive}) {
    for (const char* name : {"short", "long", "longer", "late"}) std::filesystem::remove_all(folder / name);
    ASSERT_EQ(
        run("run s.toml -o short --set 'run.duration=61.3 s' --set 'output.kept_checkpoint_interval=61.3 s'" + options)
            .code,
        0);
    EXPECT_EQ(record("short").at("t_s"), 61.3);
    EXPECT_EQ(record("short").at("reason"), "");
    EXPECT_TRUE(contains(text_of(folder / "short/tracks.csv"), "\n1,61.3,"));
    EXPECT_TRUE(contains(text_of(folder / "short/health.csv"), "\n61.3,"));
    EXPECT_EQ(store::read_film(folder / "short").frames.back().t, 61.3);
    EXPECT_EQ(json::parse(text_of(folder / "short/summary.json")).at("duration_s"), 61.3);
    const std::string all = "--set 'run.duration=80 s' --set 'output.kept_checkpoint_interval=12 s'";
    ASSERT_EQ(run("run s.toml -o long " + all + options).code, 0);
    ASSERT_EQ(run("resume short -o longer --quiet " + all).code, 0);
    ASSERT_EQ(run("resume short -o late --at '70 s' --quiet " + all).code, 0);
    for (const char* branch : {"longer", "late"}) expect_same_results(branch, "long");
  }
}

TEST_F(Resume, GoesOnFromBeforeAShortenedEndAlsoWhereThatWasWrittenTwice) {
  const std::string options = " --set 'run.duration=61.3 s' --quiet";
  ASSERT_EQ(run("run s.toml -o short" + options).code, 0);
  std::filesystem::copy(folder / "short", folder / "whole", std::filesystem::copy_options::recursive);
  for (const bool twice : {false, true}) {
    json changed = record("short"); // as if it was killed among its last files
    changed["status"] = "running";
    write("short/run.json", changed.dump());
    if (twice)
      std::filesystem::copy_file(folder / "short/checkpoint.h5", folder / "short/checkpoint_prev.h5",
                                 std::filesystem::copy_options::overwrite_existing);
    ASSERT_EQ(run("resume short --quiet").code, 0);
    expect_same_results("short", "whole");
  }
  ASSERT_EQ(run("run s.toml -o long --quiet --set 'run.duration=80 s'").code, 0);
  ASSERT_EQ(run("resume short -o longer --quiet --set 'run.duration=80 s'").code, 0);
  expect_same_results("longer", "long");
}

TEST_F(Resume, SaysHowADoneRunBranches) {
  ASSERT_EQ(run("run s.toml -o trunk --quiet").code, 0);
  const Ended ended = run("resume trunk --seed 2 -o b");
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(contains(ended.err, "trunk/checkpoint.h5: the checkpoint is at 60 s, and the branch would end at 60 s: "
                                  "--hours sets a later end, --at an earlier time to branch at"))
      << ended.err;
}

TEST_F(Resume, ABranchThatTurnsFibresOnOrOffKeepsItsFrames) {
  const auto frames = [&](const std::string& of) { return observe::times_of(store::read_film(folder / of)); };
  for (const std::string from : {"none", "isotropic"}) {
    const std::string to = from == "none" ? "isotropic" : "none";
    ASSERT_EQ(run("run s.toml -o trunk --quiet --set fibres.stiffness='10 Pa' --set fibres.arrangement=" + from).code,
              0);
    const Ended ended = run("resume trunk --at '30 s' -o b --set fibres.arrangement=" + to);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_FALSE(contains(ended.err + ended.out, "lost")) << ended.err;
    EXPECT_EQ(frames("b"), frames("trunk")) << from;
    EXPECT_EQ(run("report b").code, 0);
    for (const char* name : {"trunk", "b"}) std::filesystem::remove_all(folder / name);
  }
}

TEST_F(Resume, ABranchThatWasKilledBeforeItsFirstCheckpointBeginsAgain) {
  ASSERT_EQ(
      run("run s.toml -o trunk --quiet --set output.checkpoint_interval=0 --set output.kept_checkpoint_interval=0")
          .code,
      0);
  const std::string command =
      "resume trunk --at '40 s' --seed 2 -o b --quiet"; // from the start on: there is nothing closer
  ASSERT_EQ(run(command).code, 0);
  std::filesystem::rename(folder / "b", folder / "whole");
  bool killed = false;
  for (int attempt = 0; attempt < 20 && !killed; ++attempt) {
    std::filesystem::remove_all(folder / "b");
    stopped(command, "b/tracks.csv", "kill -s KILL $p");
    killed = exists("b/run.json") && !exists("b/checkpoint.h5");
  }
  ASSERT_TRUE(killed);
  const Ended resumed = run("resume b");
  EXPECT_EQ(resumed.code, 5);
  EXPECT_TRUE(contains(resumed.err, "the command that began it begins it again: matrigrate resume trunk --at '40 s'"))
      << resumed.err;
  EXPECT_EQ(run("resume trunk --at '40 s' --seed 3 -o b --quiet").code, 5) << "another branch";
  EXPECT_EQ(run(command).code, 0);
  expect_same_results("b", "whole");
  const Ended again = run(command);
  EXPECT_EQ(again.code, 5) << "it is there now";
  EXPECT_TRUE(contains(again.err, "it holds this branch, which goes on with: matrigrate resume b;")) << again.err;
}

TEST_F(Resume, WorksAloneInItsFolder) {
  const std::string other = "'" MATRIGRATE_PROGRAM "' resume here 2>other; echo $? >code; kill -s TERM $p";
  EXPECT_EQ(stopped("run s.toml -o here --hours 1000 --quiet --set protrusion.initiation_rate=1e-12",
                    "here/checkpoint.h5", other),
            75);
  EXPECT_EQ(text_of(folder / "code"), "5\n");
  EXPECT_TRUE(contains(text_of(folder / "other"), "another process")) << text_of(folder / "other");
}

TEST_F(Resume, KeepsWhatIsSafeWhereAFileMayNotGrow) {
  // A limit of 150 kB a file: checkpoints of this run are larger.
  const std::string command = fmt::format("cd '{}' && bash -c 'ulimit -f 150; exec \"$0\" \"$@\"' '" MATRIGRATE_PROGRAM
                                          "' run s.toml -o here --quiet >/dev/null 2>'{}'",
                                          folder.string(), (base / "err").string());
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 5);
  const std::string said = text_of(base / "err");
  EXPECT_TRUE(contains(said, "checkpoint")) << said;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "here"))
    EXPECT_FALSE(contains(entry.path().filename().string(), "checkpoint_next")) << entry.path();
  EXPECT_EQ(run("run s.toml -o here --quiet").code, 0) << "with room again";
}

} // namespace
} // namespace matrigrate
