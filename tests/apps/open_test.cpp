#include "program.hpp"

#include <chrono>

namespace matrigrate {
namespace {

class Open : public Program {};

TEST_F(Open, PrintsWhereThePageIsWithoutAScreen) {
  std::filesystem::create_directory(folder / "cell-seed1");
  write("cell-seed1/report.html", "<p>");
  const std::string page = (folder / "cell-seed1/report.html").string();
  for (const char* what : {"cell-seed1", "cell-seed1/", "cell-seed1/report.html"})
    EXPECT_EQ(run(std::string("open --print ") + what).out, page + "\n");
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const Ended ended = run("open cell-seed1");
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, "open " + page + "\n");
}

TEST_F(Open, TakesTheNewestPageOfReproduce) {
  std::filesystem::create_directory(folder / "reproduce");
  write("reproduce/report-A.html", "<p>");
  write("reproduce/report-B.html", "<p>");
  std::filesystem::last_write_time(folder / "reproduce/report-A.html",
                                   std::filesystem::last_write_time(folder / "reproduce/report-B.html")
                                       + std::chrono::seconds(5));
  EXPECT_TRUE(contains(run("open --print reproduce").out, "reproduce/report-A.html\n"));
}

TEST_F(Open, SaysHowToMakeAPageThatIsMissing) {
  EXPECT_EQ(run("open nowhere").code, 5);
  std::filesystem::create_directory(folder / "bare");
  const Ended ended = run("open bare");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "`matrigrate report bare` writes it")) << ended.err;
}

/// The program in a folder of its own, as installed.
class Live : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    std::filesystem::create_directories(base / "usr/bin");
    std::filesystem::create_directories(base / "usr/share/matrigrate");
    std::filesystem::copy_file(MATRIGRATE_PROGRAM, base / "usr/bin/matrigrate");
    std::ofstream(page()) << "<p>a cell";
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
  }
  std::filesystem::path page() const { return base / "usr/share/matrigrate/live.html"; }
  Ended live(const std::string& arguments) const { return run("live " + arguments, base / "usr/bin/matrigrate"); }
};

TEST_F(Live, OpensThePageThatIsInstalledBesideTheProgram) {
  EXPECT_EQ(live("--print").out, page().string() + "\n");
  EXPECT_EQ(live("").out, "open " + page().string() + "\n") << "there is no screen";
  const std::string opener = (folder / "xdg-open").string();
  write("xdg-open", "#!/bin/sh\necho \"$1\" >opened\n");
  std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
  ::setenv("DISPLAY", ":0", 1);
  const Ended ended = live("");
  ::setenv("PATH", path.c_str(), 1);
  ::unsetenv("DISPLAY");
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(text_of(folder / "opened"), page().string() + "\n");
}

TEST_F(Live, FindsThePageInAPythonPackageThatHoldsTheProgram) {
  std::filesystem::rename(page(), base / "usr/live.html");
  EXPECT_EQ(live("--print").out, (base / "usr/live.html").string() + "\n");
}

TEST_F(Live, FindsTheReleasedPageInACloneThatHasBuiltNone) {
  std::filesystem::create_directories(base / "clone/build/release/bin");
  std::filesystem::create_directories(base / "clone/live");
  std::filesystem::rename(base / "usr/bin/matrigrate", base / "clone/build/release/bin/matrigrate");
  std::filesystem::rename(page(), base / "clone/live/index.html");
  EXPECT_EQ(run("live --print", base / "clone/build/release/bin/matrigrate").out,
            (base / "clone/live/index.html").string() + "\n");
}

TEST_F(Live, CopiesThePageAndNeverOverwrites) {
  EXPECT_EQ(live("-o live.html").code, 0);
  EXPECT_EQ(text_of(folder / "live.html"), "<p>a cell");
  write("live.html", "mine");
  const Ended again = live("-o live.html");
  EXPECT_EQ(again.code, 5);
  EXPECT_TRUE(contains(again.err, "is not overwritten")) << again.err;
  EXPECT_EQ(text_of(folder / "live.html"), "mine");
  EXPECT_EQ(live("-o nowhere/live.html").code, 5);
  EXPECT_EQ(live("-o other.html --print").code, 2);
}

TEST_F(Live, SaysWhereToGetAPageThatIsNotInstalled) {
  std::filesystem::remove(page());
  for (const char* arguments : {"", "--print", "-o live.html"}) {
    const Ended ended = live(arguments);
    EXPECT_EQ(ended.code, 5);
    EXPECT_TRUE(contains(ended.err, page().string()) && contains(ended.err, "in live/")) << ended.err;
  }
  EXPECT_EQ(entries(), 0U);
}

class Diff : public Program {};

TEST_F(Diff, OfScenariosListsTheParametersThatDiffer) {
  run("new a.toml");
  run("new b.toml --preset soft");
  const Ended ended = run("diff a.toml b.toml");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(contains(ended.out, "ecm.youngs_modulus  \"200 Pa\"  \"50 Pa\"")) << ended.out;
  EXPECT_EQ(run("diff a.toml a.toml").out, "The parameters are the same.\n");
}

TEST_F(Diff, OfRunsTellsFromWhenOnTheyDiffer) {
  run("new cell.toml");
  run("run cell.toml --hours 0.05 -o one --quiet");
  run("run cell.toml --hours 0.05 --threads 2 -o two --quiet");
  run("run cell.toml --hours 0.05 --seed 2 -o three --quiet");
  const Ended same = run("diff one two");
  EXPECT_TRUE(contains(same.out, "The trajectories have the same bits.")) << same.out << same.err;
  const Ended other = run("diff one three --json");
  EXPECT_TRUE(contains(other.out, "\"run.seed\",\n      \"1\",\n      \"2\"")) << other.out;
  EXPECT_TRUE(contains(other.out, "\"same_trajectory\": false")) << other.out;
  EXPECT_TRUE(contains(other.out, "\"v_migr_abs_um_per_h\"")) << other.out;
}

TEST_F(Diff, RefusesWhatIsNoRun) {
  std::filesystem::create_directory(folder / "bare");
  run("new a.toml");
  EXPECT_EQ(run("diff bare a.toml").code, 5);
  EXPECT_EQ(run("diff nowhere a.toml").code, 5);
  EXPECT_EQ(run("diff a.toml").code, 2);
  write("bad.toml", "[ecm]\nyoungs_modulus = \"-1 Pa\"\n");
  EXPECT_EQ(run("diff a.toml bad.toml").code, 3);
}

class Demo : public Program {};

TEST_F(Demo, RunsWithoutAScenarioAndNeverOverwrites) {
  for (const char* expected : {"matrigrate-demo/report.html", "matrigrate-demo-2/report.html"}) {
    const Ended ended = run("demo --hours 0.02 --no-open");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(exists(expected));
  }
  EXPECT_EQ(run("demo --preset nothing").code, 2);
  EXPECT_EQ(run("demo --hours -1").code, 3);
  EXPECT_EQ(run("demo -o matrigrate-demo").code, 5) << "that folder is in use";
  EXPECT_EQ(entries(), 2U);
}

class FolderNames : public Program {};

TEST_F(FolderNames, CarryWhatSetChanges) {
  run("new cell.toml");
  run("run cell.toml --hours 0.01 --quiet --set ecm.youngs_modulus='50 Pa' --set run.seed=4 --set run.threads=1");
  EXPECT_TRUE(exists("cell-seed4-youngs_modulus-50Pa/report.html"));
}

} // namespace
} // namespace matrigrate
