#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace matrigrate {
namespace {

using nlohmann::json;

/// Frames of a short run, and all that is made of them.
class Fields : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[output]\ntrack_interval = \"8 s\"\nfield_interval = \"16 s\"\n");
  }
  json data(const std::string& file) const { return json::parse(page_data(file)); }
};

TEST_F(Fields, AreWrittenAndPlayed) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  EXPECT_TRUE(exists("here/fields.h5"));
  EXPECT_FALSE(exists("here/fields.part")) << "only a run that goes on needs it";
  EXPECT_TRUE(contains(text_of(folder / "here/fields.xdmf"), "fields.h5:/frames/0/matrix/displacement"));
  const json page = data("here/report.html");
  EXPECT_EQ(page.at("frames").at("times_s"), json::parse("[0.0, 16.0, 32.0, 36.0]"));
  EXPECT_EQ(page.at("tracks").at("t_s").size(), 6U);
  EXPECT_EQ(page.at("title"), "s: E = 200 Pa, seed 1");
  EXPECT_TRUE(contains(page.at("summary"), " protrusion")) << page.at("summary");
  std::map<std::string, std::string> facts;
  for (const json& fact : page.at("facts")) facts[fact.at("name")] = fact.at("value");
  EXPECT_EQ(facts["scenario"], "s");
  EXPECT_EQ(facts["seed"], "1");
  EXPECT_EQ(facts["command"], "matrigrate run s.toml --hours 0.01 -o here --quiet");
  EXPECT_EQ(facts["trajectory hash"], json::parse(text_of(folder / "here/run.json")).at("trajectory_hash"));
  EXPECT_TRUE(facts["date"].ends_with(" UTC") && facts.contains("wall time"));
  ASSERT_EQ(run("report here").code, 0);
  const json again = data("here/report.html");
  EXPECT_EQ(again.at("frames"), page.at("frames"));
  EXPECT_EQ(again.at("tracks"), page.at("tracks"));
  EXPECT_EQ(again.at("readouts"), page.at("readouts"));
  EXPECT_EQ(again.at("title"), page.at("title"));
  EXPECT_EQ(again.at("summary"), page.at("summary"));
  EXPECT_EQ(run("report nowhere").code, 5);
}

TEST_F(Fields, CanBeSwitchedOff) {
  ASSERT_EQ(
      run("run s.toml --hours 0.002 -o lean --quiet --set output.field_interval=0 --set output.report=false").code, 0);
  for (const char* name : {"fields.h5", "fields.xdmf", "fields.part", "report.html"})
    EXPECT_FALSE(exists(std::string("lean/") + name)) << name;
  EXPECT_TRUE(exists("lean/tracks.csv"));
  ASSERT_EQ(run("report lean").code, 0);
  EXPECT_TRUE(data("lean/report.html").at("frames").is_null());
  const Ended ended = run("export lean --fields");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "output.field_interval")) << ended.err;
}

TEST_F(Fields, AreExported) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  ASSERT_EQ(run("export here --fields --tracks -o out").code, 0);
  for (const char* name :
       {"fields.h5", "fields.xdmf", "tracks_celltrackr.csv", "tracks_trackmate.csv", "tracks_trackmate.xml"})
    EXPECT_TRUE(exists(std::string("out/") + name)) << name;
  const std::string path = text_of(folder / "out/tracks_celltrackr.csv");
  EXPECT_EQ(std::count(path.begin(), path.end(), '\n'), 1 + 6);
  EXPECT_EQ(run("export here").code, 2);
  EXPECT_EQ(run("export here --png --layer depth -o no").code, 2);
  const Ended no_fibres = run("export here --png --layer fibre_von_mises -o no");
  EXPECT_EQ(no_fibres.code, 2);
  EXPECT_TRUE(contains(no_fibres.err, "its matrix has no fibres")) << no_fibres.err;
  for (const auto& [option, instead] : {std::pair{"--svg", "--panel"}, std::pair{"--vtk", "fields.xdmf"}}) {
    const Ended gone = run(std::string("export here -o no ") + option);
    EXPECT_EQ(gone.code, 2);
    EXPECT_TRUE(contains(gone.err, std::string(option) + ": has gone: ") && contains(gone.err, instead)) << gone.err;
  }
  EXPECT_FALSE(exists("no"));
}

TEST_F(Fields, AreExportedBesideOtherExports) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  ASSERT_EQ(run("export here --simularium").code, 0);
  ASSERT_EQ(run("export here --tracks").code, 0) << "another kind";
  EXPECT_TRUE(exists("here/export/run.simularium"));
  EXPECT_TRUE(exists("here/export/tracks_celltrackr.csv"));
  write("here/export/run.simularium", "mine");
  write("here/export/notes.txt", "mine");
  const Ended ended = run("export here --fields --simularium");
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(ended.err, "here/export/run.simularium: exists; --simularium --force replaces")) << ended.err;
  EXPECT_EQ(text_of(folder / "here/export/run.simularium"), "mine");
  EXPECT_FALSE(exists("here/export/fields.h5")) << "nothing is written";
  EXPECT_EQ(run("export here --simularium --force").code, 0);
  EXPECT_NE(text_of(folder / "here/export/run.simularium"), "mine");
  EXPECT_TRUE(exists("here/export/notes.txt"));
  EXPECT_TRUE(exists("here/export/tracks_celltrackr.csv"));
  EXPECT_EQ(run("export here --fields -o here --force").code, 5) << "not into the run";
}

TEST_F(Fields, OfAnUnfinishedRunAreExported) {
  // without protrusions the cell never reaches the rim, however long the export takes
  const int code =
      stopped("run s.toml --hours 1000 --set protrusion.initiation_rate=0 -o here --quiet", "here/checkpoint.h5",
              "until grep -q '^1,40,' here/tracks.csv || ! kill -0 $p; do sleep 0.01; done; "
              "'" MATRIGRATE_PROGRAM "' export here --fields >/dev/null; kill -s KILL $p");
  EXPECT_NE(code, 0);
  EXPECT_FALSE(exists("here/fields.h5"));
  EXPECT_TRUE(contains(text_of(folder / "here/export/fields.xdmf"), "fields.h5:/frames/2/matrix/displacement"));
  EXPECT_TRUE(text_of(folder / "here/export/fields.h5").starts_with("\x89HDF"));
}

TEST_F(Fields, AreDrawnAtTimesAndInSizesThatThereAre) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  for (const char* wrong : {"'1 um'", "'3 h'", "soon", "'1,,2'"}) {
    const Ended ended = run(std::string("export here -o no --panel ") + wrong);
    EXPECT_EQ(ended.code, 2) << wrong;
    EXPECT_TRUE(contains(ended.err, "--panel")) << ended.err;
  }
  const Ended unread = run("export here -o no --panel soon");
  EXPECT_TRUE(contains(unread.err, "; an example: --panel \"0 h, 1 h, 3 h, 6 h\"")) << unread.err;
  for (const char* size : {"1280", "1281x720", "100x100", "axb", "640x480x2"})
    EXPECT_EQ(run(std::string("export here --movie -o no --size ") + size).code, 2) << size;
  EXPECT_FALSE(exists("no"));
}

/// What `export --png` asks of the player, written down by a program in place of node.
TEST_F(Fields, PicturesShowTheCellUnlessTheWholeIsWanted) {
  ASSERT_EQ(run("run s.toml --hours 0.01 -o here --quiet").code, 0);
  std::filesystem::create_directory(folder / "bin");
  write("bin/node", "#!/bin/sh\ncp \"$2\" '" + (folder / "job.json").string() + "'\nexit 1\n");
  write("bin/ffmpeg", "#!/bin/sh\n");
  for (const char* name : {"bin/node", "bin/ffmpeg"})
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
  const char* known = std::getenv("PATH");
  const std::string path = known != nullptr ? known : "";
  const char* browser = std::getenv("CHROMIUM");
  const std::string named = browser != nullptr ? browser : "";
  ::setenv("PATH", ((folder / "bin").string() + ":" + path).c_str(), 1);
  ::setenv("CHROMIUM", "/bin/sh", 1);
  const auto shown = [&](const std::string& options) {
    EXPECT_EQ(run("export here -o no " + options).code, 5);
    return json::parse(text_of(folder / "job.json"));
  };
  for (const auto& [options, follow, whole] :
       {std::tuple{"--png", true, false}, std::tuple{"--png --whole", false, true}, std::tuple{"--movie", false, false},
        std::tuple{"--movie --follow", true, false}}) {
    const json show = shown(options).at("show");
    EXPECT_EQ(show.at("follow"), follow) << options;
    EXPECT_EQ(show.at("whole"), whole) << options;
  }
  for (const auto& [times, frames] :
       {std::pair{"'16 s, 33 s'", "[[1, 16.0], [2, 32.0]]"}, std::pair{"'every 32 s'", "[[0, 0.0], [2, 32.0]]"}})
    EXPECT_EQ(shown(std::string("--png --times ") + times).at("frames"), json::parse(frames));
  EXPECT_EQ(shown("--png").at("frames").size(), 4U);
  EXPECT_TRUE(contains(run("export here -o no --png --times '3 h'").err, "--times: there is no frame at 3 h"));
  ::setenv("PATH", path.c_str(), 1);
  named.empty() ? ::unsetenv("CHROMIUM") : ::setenv("CHROMIUM", named.c_str(), 1);
}

TEST_F(Fields, PagesSayThatTheSourcesWereChanged) {
  ASSERT_EQ(run("run s.toml --hours 0.002 -o here --quiet").code, 0);
  json record = json::parse(text_of(folder / "here/run.json"));
  for (const bool changed : {true, false}) {
    record["git_dirty"] = changed;
    write("here/run.json", record.dump());
    ASSERT_EQ(run("report here").code, 0);
    EXPECT_EQ(contains(page_data("here/report.html"), "built from changed sources"), changed);
  }
}

TEST_F(Fields, NeedsToolsForPixels) {
  ASSERT_EQ(run("run s.toml --hours 0.002 -o here --quiet").code, 0);
  const char* known = std::getenv("PATH");
  const std::string path = known != nullptr ? known : "";
  ASSERT_EQ(::setenv("CHROMIUM", "/nope", 1), 0);
  const Ended browser = run("export here --movie -o no");
  EXPECT_EQ(browser.code, 5);
  EXPECT_TRUE(contains(browser.err, "CHROMIUM is /nope, which is not a program")) << browser.err;
  ::unsetenv("CHROMIUM");
  ASSERT_EQ(::setenv("TMPDIR", "/nowhere", 1), 0);
  const Ended homeless = run("export here --png -o no");
  ::unsetenv("TMPDIR");
  EXPECT_EQ(homeless.code, 5);
  EXPECT_TRUE(contains(homeless.err, "/nowhere: is no folder to work in: ")) << homeless.err;
  ASSERT_EQ(::setenv("PATH", "/nowhere", 1), 0);
  const Ended ended = run("export here --movie");
  const Ended pixels = run("export here --png");
  const Ended panel = run("export here --panel '0, 4 s'");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.code, 5);
  EXPECT_TRUE(contains(
      ended.err, "chromium and node and ffmpeg are needed for a movie; Debian: apt-get install chromium nodejs ffmpeg"))
      << ended.err;
  EXPECT_EQ(pixels.code, 5);
  EXPECT_TRUE(contains(pixels.err, "chromium and node are needed for pictures of the player")) << pixels.err;
  EXPECT_EQ(panel.code, 5);
  EXPECT_TRUE(contains(panel.err, "there is no frame at 4 s; the nearest is taken, at ")) << panel.err;
  EXPECT_FALSE(exists("here/export"));
}

} // namespace
} // namespace matrigrate
