#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace matrigrate {
namespace {

using nlohmann::json;

class Run : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[output]\ntrack_interval = \"8 s\"\n");
  }
  json record(const std::string& of) const { return json::parse(text_of(folder / of / "run.json")); }
};

TEST_F(Run, WritesItsFiles) {
  const Ended ended = run("run s.toml --hours 0.01 --seed 7");
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_EQ(ended.err, "");
  EXPECT_TRUE(contains(ended.out, "Done: 36 s, 90 steps.")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "speed, start to end (um/h)")) << ended.out;
  EXPECT_TRUE(contains(ended.out, "open s-seed7/report.html")) << ended.out;
  for (const char* file : {"scenario.resolved.toml", "run.json", "tracks.csv", "protrusions.csv", "health.csv",
                           "summary.csv", "summary.json", "report.html"})
    EXPECT_TRUE(exists(std::string("s-seed7/") + file)) << file;
  const std::string tracks = text_of(folder / "s-seed7/tracks.csv");
  EXPECT_TRUE(tracks.starts_with("track,t_s,x_um,y_um,area_um2,perimeter_um,polarization_rad,")) << tracks;
  EXPECT_EQ(std::count(tracks.begin(), tracks.end(), '\n'), 1 + 6) << "0, 8, 16, 24, 32 and 36 s";
  EXPECT_TRUE(text_of(folder / "s-seed7/health.csv").starts_with("t_s,step,solver_iterations,"));
  EXPECT_TRUE(text_of(folder / "s-seed7/protrusions.csv").starts_with("id,centre_particle,t_initiation_s,"));
  EXPECT_EQ(json::parse(text_of(folder / "s-seed7/summary.json")).at("duration_s"), 36.0);
  EXPECT_EQ(run("check s-seed7/scenario.resolved.toml").code, 0);
}

TEST_F(Run, RecordsWhatItWas) {
  ASSERT_EQ(run("run s.toml --hours 0.005 --seed 3 -o here --quiet").code, 0);
  const json r = record("here");
  EXPECT_EQ(r.at("status"), "done");
  EXPECT_EQ(r.at("exit_code"), 0);
  EXPECT_EQ(r.at("seed"), 3);
  EXPECT_EQ(r.at("steps"), 45);
  EXPECT_EQ(r.at("trajectory_hash").get<std::string>().size(), 16U);
  EXPECT_EQ(r.at("command_line").at(1), "run");
  for (const char* key : {"wall_time_s", "ms_per_step", "configuration_hash", "start", "end", "version", "git_hash",
                          "git_dirty", "compiler", "flags", "libraries", "cpu", "lineage", "reason"})
    EXPECT_TRUE(r.contains(key)) << key;
  EXPECT_TRUE(r.at("end").get<std::string>().ends_with("Z"));
}

TEST_F(Run, GivesTheSameBitsAgain) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o a --quiet --set protrusion.initiation_rate=0.01").code, 0);
  ASSERT_EQ(run("run a/scenario.resolved.toml -o b --quiet --threads 2").code, 0);
  ASSERT_EQ(run("run a/scenario.resolved.toml -o c --quiet --seed 2").code, 0);
  EXPECT_EQ(record("a").at("trajectory_hash"), record("b").at("trajectory_hash"));
  EXPECT_EQ(record("a").at("configuration_hash"), record("b").at("configuration_hash"));
  EXPECT_NE(record("a").at("trajectory_hash"), record("c").at("trajectory_hash"));
  EXPECT_NE(record("a").at("configuration_hash"), record("c").at("configuration_hash"));
  EXPECT_EQ(text_of(folder / "a/tracks.csv"), text_of(folder / "b/tracks.csv"));
  EXPECT_GT(json::parse(text_of(folder / "a/summary.json")).at("n_protrusions"), 0);
  EXPECT_GT(std::ranges::count(text_of(folder / "a/protrusions.csv"), '\n'), 1) << "those alive at the end too";
}

TEST_F(Run, SpeaksJson) {
  const Ended ended = run("run s.toml --hours 0.002 --json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json found = json::parse(ended.out);
  EXPECT_EQ(found.at("folder"), "s-seed1");
  EXPECT_EQ(found.at("status"), "done");
  EXPECT_TRUE(found.at("summary").contains("v_migr_abs_um_per_h"));
}

TEST_F(Run, RefusesAFolderThatIsNotEmpty) {
  std::filesystem::create_directory(folder / "here");
  write("here/mine", "mine");
  const Ended ended = run("run s.toml --hours 0.002 -o here");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "it holds mine; choose another folder with -o, or pass --force")) << ended.err;
  EXPECT_FALSE(exists("here/run.json"));
  const Ended forced = run("run s.toml --hours 0.002 -o here --force --quiet");
  EXPECT_EQ(forced.code, 0);
  EXPECT_TRUE(contains(forced.err, "these are not files of a run and are kept: mine")) << forced.err;
  EXPECT_TRUE(exists("here/run.json"));
  EXPECT_EQ(text_of(folder / "here/mine"), "mine");
}

TEST_F(Run, SaysInWhatARunInItsFolderDiffers) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  const std::string before = text_of(folder / "here/run.json");
  const Ended ended = run("run s.toml --hours 0.002 --seed 4 --set ecm.youngs_modulus=50 --threads 2 -o here");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "here: holds another run (done, 36 s of 36 s):\n")) << ended.err;
  for (const char* line : {"\n  ecm.youngs_modulus: 200 Pa there, 50 Pa here\n", "\n  run.seed: 1 there, 4 here\n",
                           "\n  run.duration: 0.01 h there, 0.002 h here\n"})
    EXPECT_TRUE(contains(ended.err, line)) << ended.err;
  EXPECT_FALSE(contains(ended.err, "run.threads")) << "which changes no result";
  for (const char* offer : {"matrigrate resume here", "-o FOLDER", "--force"})
    EXPECT_TRUE(contains(ended.err, offer)) << ended.err;
  EXPECT_EQ(text_of(folder / "here/run.json"), before);
}

TEST_F(Run, ReplacesAllFilesOfARunIfForced) {
  const std::string options = " --quiet --set output.kept_checkpoint_interval=10 --set output.field_interval=12";
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here" + options).code, 0);
  ASSERT_EQ(run("export here --fields --tracks").code, 0);
  std::filesystem::create_directory(folder / "here/snapshots");
  for (const char* name : {"snapshots/t_00010s.svg", "snapshots.svg", "export/path.svg", "export/matrix_0001.vtp"})
    write(std::string("here/") + name, "of an earlier version");
  for (const char* name : {"snapshots/mine.svg", "export/mine.csv", "notes.txt"})
    write(std::string("here/") + name, "mine");
  ASSERT_EQ(run("run s.toml --hours 0.002 --seed 2 -o fresh" + options).code, 0);
  const Ended ended = run("run s.toml --hours 0.002 --seed 2 -o here --force" + options);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.err, "are kept: notes.txt, snapshots/mine.svg, export/mine.csv")) << ended.err;
  const auto all_of = [&](const std::string& in) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / in))
      names.push_back(std::filesystem::relative(entry.path(), folder / in));
    std::ranges::sort(names);
    return names;
  };
  std::vector<std::string> expected = all_of("fresh");
  expected.insert(expected.end(), {"notes.txt", "snapshots", "snapshots/mine.svg", "export", "export/mine.csv"});
  std::ranges::sort(expected);
  EXPECT_EQ(all_of("here"), expected);
}

TEST_F(Run, KeepsStudiesAndLinksAsTheyAre) {
  std::filesystem::create_directories(folder / "study");
  write("study/study.resolved.toml", "mine");
  for (const char* force : {"", " --force"}) {
    const Ended ended = run(std::string("run s.toml --hours 0.002 -o study") + force);
    EXPECT_EQ(ended.code, 5);
    EXPECT_TRUE(contains(ended.err, "study: is the folder of a study; choose another")) << ended.err;
  }
  EXPECT_FALSE(exists("study/run.json"));
  std::filesystem::create_directories(folder / "linked");
  std::filesystem::create_directories(folder / "elsewhere");
  std::filesystem::create_directory_symlink("../elsewhere", folder / "linked/snapshots");
  const Ended ended = run("run s.toml --hours 0.002 -o linked --force");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "linked/snapshots: is a symbolic link")) << ended.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder / "elsewhere"));
  EXPECT_FALSE(exists("linked/run.json"));
}

TEST_F(Run, WritesNothingOnABadConfiguration) {
  const Ended ended = run("run s.toml --set ecm.radius=1 --hours -1 --set run.sed=3");
  EXPECT_EQ(ended.code, 3);
  for (const char* key : {"--set: ecm.radius", "--hours: run.duration", "--set: run.sed"})
    EXPECT_TRUE(contains(ended.err, key)) << ended.err;
  EXPECT_TRUE(contains(run("run s.toml --set run.duration=-1").err, "--set: run.duration"));
  const Ended none = run("run none.toml");
  EXPECT_EQ(none.code, 5);
  EXPECT_TRUE(contains(none.err, "none.toml: cannot be read: No such file or directory")) << none.err;
  const Ended step = run("run s.toml --set run.time_step=10");
  EXPECT_EQ(step.code, 3);
  EXPECT_TRUE(step.err.starts_with("--set: run.time_step: a step of 10 s is longer than")) << step.err;
  EXPECT_TRUE(contains(step.err, " s or less")) << step.err;
  EXPECT_EQ(entries(), 1U) << "s.toml alone";
}

TEST_F(Run, KeepsWhatItHasWhenItFails) {
  const Ended ended = run("run s.toml --hours 0.01 -o here --set solver.max_iterations=1 --set solver.tolerance=1e-12");
  EXPECT_EQ(ended.code, 4);
  EXPECT_TRUE(contains(ended.out, "Failed after 0 s of 36 s: ")) << ended.out;
  EXPECT_EQ(record("here").at("status"), "failed");
  EXPECT_EQ(record("here").at("exit_code"), 4);
  EXPECT_EQ(record("here").at("cause"), "solver");
  EXPECT_TRUE(contains(record("here").at("reason"), "was not solved")) << record("here").at("reason");
  for (const char* file : {"here/tracks.csv", "here/summary.json", "here/report.html"})
    EXPECT_TRUE(exists(file)) << file;
}

TEST_F(Run, StopsAtASignal) {
  for (const auto& [signal, code] : {std::pair<std::string, int>{"INT", 130}, {"TERM", 75}}) {
    // As `timeout` does: it tells the process, and then its group, the process among it.
    const std::string telling = "kill -s " + signal + " $p; kill -s " + signal + " -- -$p";
    EXPECT_EQ(stopped("run s.toml -o " + signal + " --hours 1000 --quiet --set protrusion.initiation_rate=1e-12",
                      signal + "/checkpoint.h5", telling),
              code);
    EXPECT_EQ(record(signal).at("status"), "interrupted");
    EXPECT_EQ(record(signal).at("exit_code"), code);
    EXPECT_GT(record(signal).at("steps"), 0);
    EXPECT_TRUE(contains(record(signal).at("reason"), "are safe in checkpoint.h5"));
    EXPECT_TRUE(exists(signal + "/report.html"));
  }
}

} // namespace
} // namespace matrigrate
