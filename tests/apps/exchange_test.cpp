#include "program.hpp"

#include "tables/table.hpp"

#include <cstdlib>

namespace matrigrate {
namespace {

/// Exports of a short run and of a study for other programs.
class Exchange : public Program {
protected:
  void SetUp() override {
    Program::SetUp();
    write("s.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"8 s\"\n[output]\ntrack_interval = \"2 s\"\n"
                    "field_interval = \"4 s\"\nreport = false\n");
  }

  void refuses(const std::string& arguments, const std::string& words) const {
    const Ended ended = run(arguments + " -o z");
    EXPECT_EQ(ended.code, 2) << arguments;
    EXPECT_TRUE(contains(ended.err, words)) << ended.err;
    EXPECT_FALSE(exists("z"));
  }
};

TEST_F(Exchange, WritesOnceAndReplacesOnlyIfTold) {
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  ASSERT_EQ(run("export r --openvt --times 'every 4 s' --simularium --ome-tiff").code, 0);
  const store::CsvTable openvt = store::read_csv(text_of(folder / "r/export/openvt.csv"));
  ASSERT_EQ(openvt.rows.size(), 3U);
  EXPECT_EQ(openvt.rows[2][1], "8");
  const std::string stack = text_of(folder / "r/export/fields.ome.tif");
  EXPECT_TRUE(contains(stack, "SizeT=\"3\""));
  write("r/export/fields.ome.tif", "mine");
  EXPECT_EQ(run("export r --ome-tiff").code, 5);
  EXPECT_EQ(text_of(folder / "r/export/fields.ome.tif"), "mine");
  ASSERT_EQ(run("export r --ome-tiff --force").code, 0);
  EXPECT_EQ(text_of(folder / "r/export/fields.ome.tif"), stack);
  ASSERT_EQ(run("export r --ome-tiff --pixel '4 um' -o coarse").code, 0);
  EXPECT_TRUE(contains(text_of(folder / "coarse/fields.ome.tif"), "SizeX=\"20\""));
}

TEST_F(Exchange, NamesEveryFaultAndWritesNothing) {
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  refuses("export r --openvt --times '0 s, x, 3 m, -1 s'", "\"x\": ");
  refuses("export r --openvt --times '0 s, x, 3 m, -1 s'", "\"3 m\": is no time; \"-1 s\": is below 0");
  refuses("export r --openvt --times '1 s, 2 s, 3 s, 1 h'",
          "s has no position at 1 s, 3 s, 3600 s: it has them every 2 s");
  refuses("export r --openvt --times 60", "\"60\": has no unit; write 60 s, 60 min or 60 h; an example");
  refuses("export r --openvt --times 'every 60'", "\"60\": has no unit");
  refuses("export r --openvt --times '2 s,'", "\"\": is no time: nothing stands between two commas, or behind");
  refuses("export r --openvt --times 'every 1e-9 s'", "every 1e-09 s is less than the time between two positions");
  refuses("export r --openvt --times 'every 1e9 h'", "is longer than the run; s has positions every 2 s, for 8 s");
  refuses("export r --panel 60", "\"60\": has no unit");
  refuses("export r --png --size 16x16", "is no size of a picture or movie");
  refuses("export r --openvt --times 'every 0 s'", "is not above 0");
  refuses("export r --tracks --times '2 s'", "--times: is for --openvt");
  refuses("export r --ome-tiff --pixel 0", "allowed are");
  refuses("export r --ome-tiff --pixel '1 s'", "is no length");
  refuses("export r --simularium --pixel '1 um'", "--pixel: is for --ome-tiff");
  ASSERT_EQ(run("run s.toml -o bare --set output.field_interval=0").code, 0);
  for (const char* kind : {"--simularium", "--ome-tiff"}) {
    const Ended ended = run(std::string("export bare -o z --openvt ") + kind);
    EXPECT_EQ(ended.code, 5) << kind;
    EXPECT_TRUE(contains(ended.err, "holds no frames")) << ended.err;
  }
  EXPECT_FALSE(exists("z"));
}

TEST_F(Exchange, OfUnevenRowsSaysWhatItLeavesOut) {
  write("u.toml", "[ecm]\nradius = \"40 um\"\n[run]\nduration = \"8 s\"\ntime_step = \"0.4 s\"\n[output]\n"
                  "track_interval = \"1 s\"\nfield_interval = \"1 s\"\nreport = false\n");
  EXPECT_TRUE(contains(run("check u.toml").out, "output.track_interval, 1 s, is no multiple of run.time_step, 0.4 s"));
  EXPECT_TRUE(contains(run("explain u.toml").out, "output.field_interval, 1 s, is no multiple of run.time_step"));
  ASSERT_EQ(run("run u.toml -o u").code, 0);
  const Ended uneven = run("export u --tracks --ome-tiff");
  EXPECT_EQ(uneven.code, 0);
  EXPECT_TRUE(contains(uneven.err, "tracks_trackmate.xml is not written, and tracks_trackmate.csv has no FRAME: the "
                                   "positions are unevenly spaced, 0.8 to 1.2 s apart"))
      << uneven.err;
  EXPECT_TRUE(contains(uneven.err, "output.track_interval is a multiple of run.time_step, 0.4 s"));
  EXPECT_FALSE(exists("u/export/tracks_trackmate.xml"));
  EXPECT_FALSE(contains(text_of(folder / "u/export/fields.ome.tif"), "TimeIncrement"));
  const Ended viewer = run("export u --simularium -o z");
  EXPECT_EQ(viewer.code, 5);
  EXPECT_TRUE(contains(viewer.err, "its frames are unevenly spaced")) << viewer.err;
  EXPECT_FALSE(exists("z"));
  ASSERT_EQ(run("run s.toml -o odd --set output.track_interval='\"3 s\"' --set output.field_interval='\"3 s\"' --set "
                "run.time_step='\"0.5 s\"'")
                .code,
            0); // rows at 0, 3, 6 and 8 s
  const Ended odd = run("export odd --tracks --simularium");
  ASSERT_EQ(odd.code, 0) << odd.err;
  EXPECT_TRUE(contains(odd.err, "the last position, at 8 s, comes sooner than 3 s after the one before it")) << odd.err;
  EXPECT_TRUE(contains(odd.err, "the last frame, at 8 s, comes sooner than 3 s")) << odd.err;
  EXPECT_TRUE(contains(text_of(folder / "odd/export/tracks_trackmate.xml"), "nSpots=\"3\""));
  EXPECT_EQ(store::read_csv(text_of(folder / "odd/export/tracks_trackmate.csv")).rows.size(), 6U) << "with titles";
  EXPECT_EQ(store::read_csv(text_of(folder / "odd/export/tracks_celltrackr.csv")).rows.size(), 4U);
}

TEST_F(Exchange, OfPythonIsRefusedInWordsWhereThatIsMissing) {
  ASSERT_EQ(run("run s.toml -o r").code, 0);
  ASSERT_EQ(::setenv("PYTHON", "/bin/false", 1), 0);
  const Ended stack = run("export r --ome-tiff --tracks");
  const Ended viewer = run("export r --simularium");
  ::unsetenv("PYTHON");
  EXPECT_EQ(stack.code, 5);
  EXPECT_TRUE(contains(stack.err, "--ome-tiff is made by Python, which needs the package matrigrate")) << stack.err;
  EXPECT_TRUE(contains(stack.err, "python3-tifffile")) << stack.err;
  EXPECT_EQ(viewer.code, 5);
  EXPECT_TRUE(contains(viewer.err, "--simularium is made by Python")) << viewer.err;
  EXPECT_FALSE(contains(viewer.err, "tifffile")) << viewer.err;
  EXPECT_FALSE(exists("r/export")) << "nothing is written";
}

TEST_F(Exchange, GivesEachRunOfAStudyItsNumber) {
  write("e.toml", "title = \"Stiffness\"\nscenario = \"s.toml\"\nreplicates = 2\n[[points]]\nlabel = \"soft, or so\"\n"
                  "ecm.youngs_modulus = \"50 Pa\"\n[[points]]\nlabel = \"stiff\"\necm.youngs_modulus = \"100 Pa\"\n");
  ASSERT_EQ(run("study run e.toml").code, 0);
  refuses("export e-study --openvt --times '1 s'", "has no position at 1 s");
  refuses("export e-study --tracks --pixel '1 um'", "--pixel: is for --ome-tiff");
  const Ended ended = run("export e-study --tracks --openvt --times '0 s, 6 s'");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const store::CsvTable openvt = store::read_csv(text_of(folder / "e-study/export/openvt.csv"));
  const store::CsvTable spots = store::read_csv(text_of(folder / "e-study/export/tracks_spots.csv"));
  const store::CsvTable results = store::read_csv(text_of(folder / "e-study/results.csv"));
  ASSERT_EQ(openvt.rows.size(), 4U * 2U);
  EXPECT_EQ(openvt.rows.back()[0], "3");
  EXPECT_EQ(openvt.rows.back()[1], "6");
  ASSERT_EQ(spots.rows.size(), 4U * 5U);
  EXPECT_EQ(spots.rows[0][4], results.rows[0][0]);
  EXPECT_EQ(spots.rows[0][1], "soft, or so");
}

} // namespace
} // namespace matrigrate
