#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace matrigrate {
namespace {

using nlohmann::json;

/// What becomes of a run whose files were damaged or removed while it was not running.
class Recovery : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[protrusion]\ninitiation_rate = \"0.001 1/s\"\n[output]\n"
                    "track_interval = \"4 s\"\ncheckpoint_interval = \"8 s\"\n"
                    "field_interval = \"8 s\"\n[run]\nduration = \"48 s\"\n");
  }

  json record(const std::string& of) const { return json::parse(text_of(folder / of / "run.json")); }
  std::vector<double> frames(const std::string& of) const {
    return json::parse(page_data(of + "/report.html")).at("frames").at("times_s");
  }
  std::string status(const std::string& of) const { return json::parse(page_data(of + "/report.html")).at("status"); }
  void copy(const std::string& from, const std::string& to) const {
    std::filesystem::copy(folder / from, folder / to, std::filesystem::copy_options::recursive);
  }
  void put(const std::string& file, const std::string& bytes) const {
    std::ofstream(folder / file, std::ios::binary) << bytes;
  }

  /// A run that was killed after its first 24 s and before its end, with a whole log of its frames.
  void make_killed(const std::string& name) const {
    for (int attempt = 0; attempt < 20; ++attempt) { // on a busy machine it may be at its end before it is killed
      std::filesystem::remove_all(folder / name);
      const std::string telling = "until grep -q '^1,24,' " + name
                                  + "/tracks.csv || ! kill -0 $p; do sleep 0.01; done; "
                                    "kill -s KILL $p";
      stopped("run s.toml -o " + name + " --quiet", name + "/checkpoint_prev.h5", telling);
      const bool at_its_end = contains(text_of(folder / name / "tracks.csv"), "\n1,48,");
      if (exists(name + "/checkpoint.h5") && exists(name + "/fields.part") && !at_its_end) return;
    }
    FAIL() << "it is always done too soon";
  }

  /// Where the k-th block of a log begins: three numbers of 64 bits, the first of which is the length of what follows.
  static std::size_t block_of(const std::string& log, int k) {
    std::size_t at = log.find('\n') + 1;
    for (; k > 0; --k) {
      std::uint64_t length = 0;
      std::memcpy(&length, log.data() + at, sizeof(length));
      at += 3 * sizeof(length) + length;
    }
    return at;
  }

  /// Expects that a run goes on, with the tables of one without a break, and tells which frames it lost.
  void expect_recovered(const std::string& here, const std::string& told) const {
    const Ended ended = run("resume " + here);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, told)) << ended.err;
    EXPECT_TRUE(contains(ended.out, told)) << ended.out;
    EXPECT_TRUE(contains(status(here), told)) << status(here);
    EXPECT_EQ(record(here).at("status"), "done");
    for (const char* file : {"tracks.csv", "health.csv", "protrusions.csv", "summary.json"})
      EXPECT_EQ(text_of(folder / here / file), text_of(folder / "whole" / file)) << file;
    EXPECT_EQ(record(here).at("trajectory_hash"), record("whole").at("trajectory_hash"));
    EXPECT_TRUE(exists(here + "/fields.h5"));
  }
};

TEST_F(Recovery, GoesOnWithoutTheFramesOfItsPast) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  const std::vector<double> all = frames("whole");
  make_killed("killed");
  const std::string log = text_of(folder / "killed/fields.part");
  for (const long size : {-1L, 0L, 10L, 19L, 20L, 30L, 100L}) {
    const std::string here = "cut" + std::to_string(size);
    copy("killed", here);
    if (size < 0)
      std::filesystem::remove(folder / here / "fields.part");
    else
      put(here + "/fields.part", log.substr(0, static_cast<std::size_t>(size)));
    expect_recovered(here, " are lost: neither fields.part nor fields.h5 holds them whole");
    const std::size_t lost = record(here).at("frames_lost");
    EXPECT_GE(lost, 3U) << size;
    EXPECT_EQ(record(here).at("frames_lost_s").at(0), 0.0);
    EXPECT_EQ(frames(here), std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(lost), all.end()));
    const Ended again = run("resume " + here + " --previous --quiet");
    EXPECT_EQ(again.code, 0) << again.err;
  }
}

TEST_F(Recovery, BranchesFromARunWhoseFramesWereRemoved) {
  ASSERT_EQ(run("run s.toml -o here --quiet").code, 0);
  std::filesystem::remove(folder / "here/fields.h5");
  std::filesystem::remove(folder / "here/fields.xdmf");
  const Ended ended = run("resume here --hours 0.02 -o longer");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.err, "7 of 7 frames (from 0 s to 48 s) are lost")) << ended.err;
  EXPECT_EQ(frames("longer"), (std::vector{56.0, 64.0, 72.0}));
  EXPECT_EQ(record("longer").at("frames_lost"), 7);
  ASSERT_EQ(run("resume here --set 'run.duration=58 s' -o odd --quiet").code, 0);
  const std::string told = "7 of 9 frames (from 0 s to 48 s) are lost"; // with the one at the end, which is not due
  EXPECT_TRUE(contains(status("odd"), told)) << status("odd");
  EXPECT_TRUE(contains(run("report odd").err, told));
  EXPECT_EQ(run("resume here --previous --quiet").code, 0) << "and the run itself";
}

TEST_F(Recovery, LosesOnlyFramesThatAreDamaged) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  std::vector<double> expected = frames("whole");
  expected.erase(expected.begin() + 1);
  make_killed("here");
  std::string log = text_of(folder / "here/fields.part");
  const std::size_t second = block_of(log, 2); // the head is a block as well
  log[second + 100] = static_cast<char>(log[second + 100] ^ 1);
  put("here/fields.part", log);
  const Ended report = run("report here");
  EXPECT_EQ(report.code, 0);
  EXPECT_TRUE(contains(report.err, "frames (at 8 s) is lost")) << report.err;
  EXPECT_TRUE(contains(status("here"), "frames (at 8 s) is lost")) << status("here");
  expect_recovered("here", "frames (at 8 s) is lost");
  EXPECT_EQ(record("here").at("frames_lost"), 1);
  EXPECT_EQ(frames("here"), expected);
}

TEST_F(Recovery, RefusesTablesThatWereEdited) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  make_killed("here");
  for (const std::string& table : {std::string("here/tracks.csv"), std::string("here/health.csv")}) {
    const std::string text = text_of(folder / table);
    std::string edited = text;
    edited.at(edited.find('\n') + 3) ^= 1; // in the first row
    put(table, edited);
    std::filesystem::remove_all(folder / "before");
    copy("here", "before");
    for (const char* verb : {"resume here", "resume here --previous", "run s.toml -o here",
                             "resume here --hours 0.02 -o longer", "report here", "export here --tracks"}) {
      const Ended ended = run(verb);
      EXPECT_EQ(ended.code, 5) << verb;
      EXPECT_TRUE(contains(ended.err, table + ": has been changed since the checkpoint was written")) << ended.err;
    }
    EXPECT_FALSE(exists("longer"));
    EXPECT_EQ(
        std::system(("diff -r '" + (folder / "here").string() + "' '" + (folder / "before").string() + "'").c_str()), 0)
        << "nothing is written";
    put(table, text);
  }
  std::filesystem::remove(folder / "here/health.csv");
  EXPECT_EQ(run("resume here").code, 5);
  copy("before/health.csv", "here/health.csv");
  EXPECT_EQ(run("resume here").code, 5) << "that one is edited";
}

TEST_F(Recovery, OffersTheCheckpointBeforeWhereATableWasCut) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  make_killed("here");
  Ended ended{.code = 0, .out = {}, .err = {}};
  for (std::string text = text_of(folder / "here/tracks.csv"); ended.code == 0 && text.size() > 200;) {
    text.erase(text.rfind('\n', text.size() - 2) + 1); // the last row
    std::filesystem::remove_all(folder / "cut");
    copy("here", "cut");
    put("cut/tracks.csv", text);
    ended = run("resume cut --quiet");
  }
  EXPECT_EQ(ended.code, 5) << ended.err;
  EXPECT_TRUE(contains(ended.err, "cut/tracks.csv: has been cut: ")) << ended.err;
  EXPECT_TRUE(contains(ended.err, " is whole: resume from it with --previous")) << ended.err;
  EXPECT_EQ(run("resume cut --previous --quiet").code, 0);
  for (const char* file : {"tracks.csv", "health.csv", "protrusions.csv", "summary.json"})
    EXPECT_EQ(text_of(folder / "cut" / file), text_of(folder / "whole" / file)) << file;
  EXPECT_EQ(record("cut").at("trajectory_hash"), record("whole").at("trajectory_hash"));
}

TEST_F(Recovery, TakesAwayWhatKilledProcessesLeft) {
  make_killed("here");
  const std::vector<std::string> ours{".fields.h5.a1B2c3", ".run.json.abcdef", ".checkpoint_next.h5.000000",
                                      "checkpoint_next.h5", "checkpoints/.t_00010s.h5.ABCDEF"};
  const std::vector<std::string> others{".fields.h5.backup2", ".notes.txt.abcdef", ".run.json.abcdefg", "mine.txt"};
  for (const auto& names : {ours, others})
    for (const std::string& name : names) put("here/" + name, "x");
  ASSERT_EQ(run("resume here --quiet").code, 0);
  for (const std::string& name : ours) EXPECT_FALSE(exists("here/" + name)) << name;
  for (const std::string& name : others) EXPECT_TRUE(exists("here/" + name)) << name;
}

TEST_F(Recovery, NeedsNoScenarioBesideACheckpoint) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  const std::string scenario = text_of(folder / "whole/scenario.resolved.toml");
  const std::string cut = scenario.substr(0, scenario.find("\n[cell]") + 1); // valid, with defaults for the rest
  for (const std::string content : {"none", "", "rubbish", "[ecm]\nradius = \"40 Pa\"\n", cut.c_str()}) {
    make_killed("here");
    content == "none" ? static_cast<void>(std::filesystem::remove(folder / "here/scenario.resolved.toml"))
                      : put("here/scenario.resolved.toml", content);
    EXPECT_EQ(run("report here").code, 0);
    EXPECT_EQ(run("export here --tracks").code, 0);
    const Ended ended = run("resume here --quiet");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "scenario.resolved.toml: missing, incomplete or not valid")) << ended.err;
    EXPECT_EQ(text_of(folder / "here/scenario.resolved.toml"), scenario) << "it is written again";
    EXPECT_EQ(record("here").at("trajectory_hash"), record("whole").at("trajectory_hash"));
    std::filesystem::remove(folder / "here/scenario.resolved.toml");
    EXPECT_EQ(run("resume here --hours 0.02 -o longer --quiet").code, 0);
    std::filesystem::remove_all(folder / "longer");
  }
}

TEST_F(Recovery, RestoresTheScenarioOfADoneRun) {
  ASSERT_EQ(run("run s.toml -o here --quiet").code, 0);
  const std::string scenario = text_of(folder / "here/scenario.resolved.toml");
  put("here/scenario.resolved.toml", scenario.substr(0, 2000));
  const Ended ended = run("resume here");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.err, "scenario.resolved.toml: missing, incomplete or not valid")) << ended.err;
  EXPECT_EQ(text_of(folder / "here/scenario.resolved.toml"), scenario);
}

TEST_F(Recovery, ReportsAndExportsWithACutLog) {
  make_killed("here");
  put("here/fields.part", text_of(folder / "here/fields.part").substr(0, 100));
  for (const char* arguments : {"report here", "export here --tracks"}) EXPECT_EQ(run(arguments).code, 0) << arguments;
  EXPECT_TRUE(contains(status("here"), " are lost")) << status("here");
}

TEST_F(Recovery, RefusesTheCheckpointOfAnotherRunAlsoWithoutAScenario) {
  ASSERT_EQ(run("run s.toml -o a --quiet").code, 0);
  ASSERT_EQ(run("run s.toml -o b --quiet --seed 2").code, 0);
  for (const char* name : {"checkpoint.h5", "checkpoint_prev.h5"})
    std::filesystem::copy_file(folder / "a" / name, folder / "b" / name,
                               std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove(folder / "b/scenario.resolved.toml");
  const Ended ended = run("resume b --previous");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "another scenario")) << ended.err;
}

TEST_F(Recovery, NamesResumeWhereTheRecordIsDamaged) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  for (const bool gone : {true, false}) {
    make_killed("here");
    gone ? static_cast<void>(std::filesystem::remove(folder / "here/run.json")) : put("here/run.json", "{\"stat");
    const Ended refused = run("run s.toml -o here --seed 7");
    EXPECT_EQ(refused.code, 5);
    EXPECT_TRUE(contains(refused.err, "matrigrate resume here")) << refused.err;
    EXPECT_FALSE(contains(refused.err, "--force")) << refused.err;
    EXPECT_EQ(run(gone ? "resume here --quiet" : "run s.toml -o here --quiet").code, 0);
    EXPECT_EQ(record("here").at("trajectory_hash"), record("whole").at("trajectory_hash"));
  }
}

TEST_F(Recovery, DoesNotBelieveARecordThatItsCheckpointContradicts) {
  ASSERT_EQ(run("run s.toml -o whole --quiet").code, 0);
  for (const char* verb : {"resume here", "run s.toml -o here"}) {
    make_killed("here");
    put("here/run.json", text_of(folder / "whole/run.json"));
    const Ended ended = run(verb);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(contains(ended.err, "says that the run is done, but its checkpoint is at ")) << ended.err;
    EXPECT_EQ(text_of(folder / "here/tracks.csv"), text_of(folder / "whole/tracks.csv"));
  }
}

TEST_F(Recovery, KeepsFilesOffClosedDescriptors) {
  std::ofstream(base / "closed.sh")
      << "cd '" << folder.string() << "'\n'" MATRIGRATE_PROGRAM
      << "' run s.toml -o here --hours 1000 --set protrusion.initiation_rate=1e-12 <&- >&- 2>&- & p=$!\n"
      << "while [ ! -e here/checkpoint.h5 ] && kill -0 $p; do sleep 0.01; done\n"
      << "for n in 0 1 2; do readlink /proc/$p/fd/$n; done >fds\n"
      << "kill -s TERM $p; wait $p\n";
  const int status = std::system(("bash '" + (base / "closed.sh").string() + "'").c_str());
  EXPECT_EQ(text_of(folder / "fds"), "/dev/null\n/dev/null\n/dev/null\n");
  EXPECT_EQ(WEXITSTATUS(status), 5) << "what is printed at the end cannot be written";
  EXPECT_EQ(record("here").at("status"), "interrupted");
}

} // namespace
} // namespace matrigrate
